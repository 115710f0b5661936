// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Layer 14: at most three short labels as DOM, kept inside the map and clear of Stop. */
export interface Tag { px: number; py: number; text: string; kind: '' | 'rejected'; /** where it lies if nothing is there; above else */ side?: Side }

const most = 3;
const gapPx = 10;

export type Side = 'above' | 'below' | 'left' | 'right';
const allSides: readonly Side[] = ['above', 'below', 'right', 'left'];
interface Box { x: number; y: number; w: number; h: number }

function boxAt(side: Side, { px, py }: Tag, w: number, h: number): Box {
  if (side === 'above') return { x: px - w / 2, y: py - h - gapPx, w, h };
  if (side === 'below') return { x: px - w / 2, y: py + gapPx, w, h };
  return { x: side === 'right' ? px + gapPx : px - w - gapPx, y: py - h / 2, w, h };
}

const within = ({ x, y, w, h }: Box, width: number, height: number): Box =>
  ({ x: Math.max(4, Math.min(width - w - 4, x)), y: Math.max(4, Math.min(height - h - 4, y)), w, h });

const overlap = (a: Box, b: Box): boolean => a.x < b.x + b.w && a.x + a.w > b.x && a.y < b.y + b.h && a.y + a.h > b.y;

export class Tags {
  private readonly elements: HTMLElement[] = [];
  private keepClear: readonly HTMLElement[] = [];

  constructor(private readonly host: HTMLElement) {}

  setKeepClear(elements: readonly HTMLElement[]): void { this.keepClear = elements; }

  show(tags: readonly Tag[], width: number, height: number): void {
    const shown = tags.filter((t) => t.px >= 0 && t.py >= 0 && t.px <= width && t.py <= height).slice(0, most);
    while (this.elements.length < shown.length) this.elements.push(this.make());
    const blocked = shown.length > 0 ? this.blocked() : [];
    const placed: Box[] = [];
    this.elements.forEach((element, i) => {
      const tag = shown[i];
      element.hidden = tag === undefined;
      if (tag) this.put(element, tag, width, height, blocked, placed);
    });
  }

  private make(): HTMLElement {
    const element = document.createElement('div');
    element.setAttribute('aria-hidden', 'true');
    this.host.append(element);
    return element;
  }

  /** Where it asks to be or, where another tag lies already, at another side of its place; hidden rather than over Stop. */
  private put(element: HTMLElement, tag: Tag, width: number, height: number, blocked: readonly Box[], placed: Box[]): void {
    if (element.textContent !== tag.text) element.textContent = tag.text;
    element.className = `map-tag ${tag.kind}`;
    const w = element.offsetWidth;
    const h = element.offsetHeight;
    const boxes = [...(tag.side ? [tag.side] : []), ...allSides].map((side) => ({ side, box: within(boxAt(side, tag, w, h), width, height) }));
    const free = boxes.find(({ box }) => ![...blocked, ...placed].some((other) => overlap(box, other)));
    const { side, box } = free ?? boxes[0] as (typeof boxes)[number];
    placed.push(box);
    element.classList.add(side);
    element.style.transform = `translate(${Math.round(box.x)}px, ${Math.round(box.y)}px)`;
    element.style.setProperty('--tip', `${Math.round(tag.px - box.x)}px`);
    element.style.visibility = blocked.some((other) => overlap(box, other)) ? 'hidden' : 'visible';
  }

  private blocked(): Box[] {
    const origin = this.host.getBoundingClientRect();
    return this.keepClear.map((e) => {
      const box = e.getBoundingClientRect();
      return { x: box.x - origin.x, y: box.y - origin.y, w: box.width, h: box.height };
    });
  }
}
