// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** What the pointer does on the map: pan, zoom, pinch, measure, click, double click, long press, two-finger tap. */
export interface Gestured {
  pan(dxPx: number, dyPx: number): void;
  zoom(factor: number, px: number, py: number): void;
  click(px: number, py: number, touch: boolean): void;
  longPress(px: number, py: number, touch: boolean): void;
  hover(px: number, py: number): void;
  leave(): void;
  /** From the first place to the second; null: it ended. */
  measure(from: { px: number; py: number } | null, to: { px: number; py: number } | null): void;
}

const clickMovePx = 5;
const longPressMs = 500;
const doubleMs = 300;
const doublePx = 24;

interface Down { px: number; py: number; beginX: number; beginY: number; beginMs: number }

export class Gestures {
  private readonly down = new Map<number, Down>();
  private moved = false;
  private measuring = false;
  private mostFingers = 0;
  private pressTimer: ReturnType<typeof setTimeout> | undefined;
  private lastClick = { px: 0, py: 0, ms: Number.NEGATIVE_INFINITY };
  private readonly abort = new AbortController();

  constructor(private readonly host: HTMLElement, private readonly to: Gestured) {
    const { signal } = this.abort;
    host.style.touchAction = 'none';
    host.addEventListener('pointerdown', (e) => this.begin(e), { signal });
    host.addEventListener('pointermove', (e) => this.move(e), { signal });
    host.addEventListener('pointerup', (e) => this.end(e, true), { signal });
    host.addEventListener('pointercancel', (e) => this.end(e, false), { signal });
    host.addEventListener('pointerleave', () => { if (this.down.size === 0) this.to.leave(); }, { signal });
    host.addEventListener('wheel', (e) => this.wheel(e), { signal, passive: false });
    host.addEventListener('contextmenu', (e) => { if (this.isMap(e)) e.preventDefault(); }, { signal });
  }

  destroy(): void {
    clearTimeout(this.pressTimer);
    this.abort.abort();
  }

  /** Buttons and tags that lie in the host are not the map. */
  private isMap(event: Event): boolean { return event.target === this.host || event.target instanceof HTMLCanvasElement; }

  private place(e: MouseEvent): { px: number; py: number } {
    const box = this.host.getBoundingClientRect();
    return { px: e.clientX - box.left, py: e.clientY - box.top };
  }

  private begin(e: PointerEvent): void {
    if (!this.isMap(e) || (e.pointerType === 'mouse' && e.button !== 0)) return;
    const { px, py } = this.place(e);
    this.host.setPointerCapture(e.pointerId);
    if (this.down.size === 0) {
      this.moved = false;
      this.mostFingers = 0;
      this.measuring = e.shiftKey;
    }
    this.down.set(e.pointerId, { px, py, beginX: px, beginY: py, beginMs: performance.now() });
    this.mostFingers = Math.max(this.mostFingers, this.down.size);
    clearTimeout(this.pressTimer);
    if (this.down.size === 1 && !this.measuring) this.pressTimer = setTimeout(() => this.press(px, py, e.pointerType === 'touch'), longPressMs);
  }

  private press(px: number, py: number, touch: boolean): void {
    if (this.moved || this.down.size !== 1) return;
    this.moved = true; // what follows is no click
    this.to.longPress(px, py, touch);
  }

  private move(e: PointerEvent): void {
    const { px, py } = this.place(e);
    const own = this.down.get(e.pointerId);
    if (!own) {
      if (this.down.size === 0 && this.isMap(e)) this.to.hover(px, py);
      return;
    }
    if (!this.moved && Math.hypot(px - own.beginX, py - own.beginY) > clickMovePx) {
      this.moved = true;
      clearTimeout(this.pressTimer);
      own.px = own.beginX;
      own.py = own.beginY;
    }
    if (!this.moved) return;
    const other = [...this.down].find(([id]) => id !== e.pointerId)?.[1];
    if (this.measuring) this.to.measure({ px: own.beginX, py: own.beginY }, { px, py });
    else if (other) this.pinch(own, other, px, py);
    else this.to.pan(own.px - px, py - own.py);
    own.px = px;
    own.py = py;
  }

  private pinch(own: Down, other: Down, px: number, py: number): void {
    const before = Math.hypot(own.px - other.px, own.py - other.py);
    const after = Math.hypot(px - other.px, py - other.py);
    this.to.pan((own.px - px) / 2, (py - own.py) / 2);
    if (before > 1) this.to.zoom(after / before, (px + other.px) / 2, (py + other.py) / 2);
  }

  private end(e: PointerEvent, clicks: boolean): void {
    const own = this.down.get(e.pointerId);
    if (!own) return;
    this.down.delete(e.pointerId);
    clearTimeout(this.pressTimer);
    if (this.measuring) this.to.measure(null, null);
    else if (clicks && !this.moved && this.down.size === 0) this.tap(own, e.pointerType === 'touch');
    if (this.down.size === 0) this.measuring = false;
  }

  private tap(own: Down, touch: boolean): void {
    const { px, py } = own;
    const now = performance.now();
    if (this.mostFingers === 2) {
      this.to.zoom(0.5, px, py);
      return;
    }
    const again = now - this.lastClick.ms < doubleMs && Math.hypot(px - this.lastClick.px, py - this.lastClick.py) < doublePx;
    this.lastClick = { px, py, ms: again ? Number.NEGATIVE_INFINITY : now };
    if (again) this.to.zoom(2, px, py);
    else this.to.click(px, py, touch);
  }

  private wheel(e: WheelEvent): void {
    if (!this.isMap(e)) return;
    e.preventDefault();
    const { px, py } = this.place(e);
    const unit = e.deltaMode === WheelEvent.DOM_DELTA_LINE ? 16 : 1;
    this.to.zoom(Math.exp(-0.0016 * unit * Math.max(-240, Math.min(240, e.deltaY))), px, py);
  }
}
