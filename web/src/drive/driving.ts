// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Commands of one who drives: held keys, the pad and a gamepad become 20 messages a second. */
import type { PageModel } from '../model/page_model.ts';
import { keysToVelocity, type Velocity } from './velocity.ts';

const periodMs = 50;
const zerosAfterRelease = 3;

export class Driving {
  private readonly held = new Set<string>();
  private pad: Velocity | null = null;
  private gamepad: Velocity | null = null;
  private zeros = 0;
  private seq = 0;
  private sentMs = Number.NEGATIVE_INFINITY;
  private timer: ReturnType<typeof setInterval> | undefined;
  wanted: Velocity = { v: 0, w: 0 };
  slow = false;
  /** performance.now() of this page's last Stop. */
  stopSentMs = Number.NEGATIVE_INFINITY;
  onChange: (() => void) | null = null;

  constructor(private readonly model: PageModel) {
    addEventListener('blur', () => this.letGo());
    document.addEventListener('visibilitychange', () => { if (document.hidden) this.leave(); });
    // Browsers that put a page to sleep, or leave it, need not tell that it was hidden before.
    document.addEventListener('freeze', () => this.leave());
    addEventListener('pagehide', () => this.leave());
    model.on('state', () => this.follow());
    model.on('connection', () => this.follow());
  }

  get active(): boolean { return this.model.connection.phase === 'live' && this.model.me >= 0 && this.model.state?.driver === this.model.me; }

  stop(): boolean {
    this.letGo();
    this.zeros = 0;
    const sent = this.model.send({ type: 'stop' });
    if (sent) this.stopSentMs = performance.now();
    return sent;
  }
  take(): boolean { return this.model.send({ type: 'take' }); }
  release(to?: number): void {
    this.letGo();
    this.model.send(to === undefined ? { type: 'release' } : { type: 'release', to });
  }

  key(name: string, down: boolean): void {
    if (down) this.held.add(name);
    else if (this.held.delete(name) && this.held.size === 0) this.zeros = zerosAfterRelease;
  }
  setPad(velocity: Velocity | null): void {
    if (this.pad && !velocity) this.zeros = zerosAfterRelease;
    this.pad = velocity;
  }
  setGamepad(velocity: Velocity | null): void {
    if (this.gamepad && !velocity) this.zeros = zerosAfterRelease;
    this.gamepad = velocity;
  }
  letGo(): void {
    if (this.held.size > 0 || this.pad || this.gamepad) this.zeros = zerosAfterRelease;
    this.held.clear();
    this.pad = null;
    this.gamepad = null;
  }

  /** It drove until a moment ago. */
  get isWindingDown(): boolean { return performance.now() - this.sentMs < 1500; }

  private leave(): void {
    if (!this.active) return;
    this.letGo();
    this.model.send({ type: 'drive', v: 0, w: 0 });
    this.release();
  }

  private follow(): void {
    if (this.active === (this.timer !== undefined)) return;
    if (this.active) this.timer = setInterval(() => this.tick(), periodMs);
    else {
      clearInterval(this.timer);
      this.timer = undefined;
      this.held.clear();
      this.pad = null;
    }
    this.onChange?.();
  }

  private tick(): void {
    const limits = this.model.welcome?.limits;
    if (!limits || document.hidden) return;
    const keys = this.held.size > 0 ? keysToVelocity(this.held, limits.speed_m_s, limits.turn_rate, this.slow) : null;
    this.wanted = this.pad ?? keys ?? this.gamepad ?? { v: 0, w: 0 };
    if (!this.pad && !keys && !this.gamepad && this.zeros > 0) this.zeros -= 1;
    // Also while standing: the right to drive ends when nothing is heard from the driver.
    this.sentMs = performance.now();
    this.model.send({ type: 'drive', v: this.wanted.v, w: this.wanted.w, seq: this.seq++ });
  }
}
