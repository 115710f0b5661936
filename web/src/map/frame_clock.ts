// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** When to draw: at once for the pointer, at most 30 times a second for data, 10 where drawing is dear. */
const dataIntervalMs = 1000 / 30;
const slowIntervalMs = 100;
const dearMs = 45;
const dearFrames = 10;

export class FrameClock {
  private request = 0;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private lastMs = 0;
  private dear = 0;
  /** Ten frames in a row took more than 45 ms: draw less. */
  slow = false;

  constructor(private readonly draw: (nowMs: number) => void) {}

  /** Something that the person moves. */
  soon(): void {
    if (this.request === 0) this.request = requestAnimationFrame((now) => this.run(now));
  }

  /** New data: may wait. */
  later(): void {
    if (this.request !== 0 || this.timer !== undefined) return;
    const wait = (this.slow ? slowIntervalMs : dataIntervalMs) - (performance.now() - this.lastMs);
    if (wait <= 2) this.soon();
    else this.timer = setTimeout(() => { this.timer = undefined; this.soon(); }, wait);
  }

  stop(): void {
    cancelAnimationFrame(this.request);
    clearTimeout(this.timer);
    this.request = 0;
    this.timer = undefined;
  }

  private run(now: number): void {
    this.stop();
    const begin = performance.now();
    this.lastMs = begin;
    this.draw(now);
    this.dear = performance.now() - begin > dearMs ? this.dear + 1 : 0;
    if (this.dear >= dearFrames) this.slow = true;
  }
}
