// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Layer 14: at most three short labels as DOM, kept inside the map and clear of Stop. */
export interface Tag { px: number; py: number; text: string; kind: '' | 'rejected'; /** beside it, not above it */ beside?: boolean }

const most = 3;
const gapPx = 10;

export class Tags {
  private readonly elements: HTMLElement[] = [];
  private keepClear: readonly HTMLElement[] = [];

  constructor(private readonly host: HTMLElement) {}

  setKeepClear(elements: readonly HTMLElement[]): void { this.keepClear = elements; }

  show(tags: readonly Tag[], width: number, height: number): void {
    const shown = tags.filter((t) => t.px >= 0 && t.py >= 0 && t.px <= width && t.py <= height).slice(0, most);
    while (this.elements.length < shown.length) this.elements.push(this.make());
    const blocked = shown.length > 0 ? this.blocked() : [];
    this.elements.forEach((element, i) => {
      const tag = shown[i];
      element.hidden = tag === undefined;
      if (tag) this.put(element, tag, width, height, blocked);
    });
  }

  private make(): HTMLElement {
    const element = document.createElement('div');
    element.setAttribute('aria-hidden', 'true');
    this.host.append(element);
    return element;
  }

  private put(element: HTMLElement, tag: Tag, width: number, height: number, blocked: readonly DOMRect[]): void {
    if (element.textContent !== tag.text) element.textContent = tag.text;
    const beside = tag.beside === true;
    element.className = `map-tag ${tag.kind} ${beside ? 'beside' : 'above'}`;
    const w = element.offsetWidth;
    const h = element.offsetHeight;
    const x = Math.max(4, Math.min(width - w - 4, beside ? tag.px + gapPx : tag.px - w / 2));
    const y = Math.max(4, Math.min(height - h - 4, beside ? tag.py - h / 2 : tag.py - h - gapPx));
    element.style.transform = `translate(${Math.round(x)}px, ${Math.round(y)}px)`;
    element.style.setProperty('--tip', `${Math.round(tag.px - x)}px`);
    const covers = blocked.some((b) => x < b.right && x + w > b.left && y < b.bottom && y + h > b.top);
    element.style.visibility = covers ? 'hidden' : 'visible';
  }

  private blocked(): DOMRect[] {
    const origin = this.host.getBoundingClientRect();
    return this.keepClear.map((e) => {
      const box = e.getBoundingClientRect();
      return new DOMRect(box.x - origin.x, box.y - origin.y, box.width, box.height);
    });
  }
}
