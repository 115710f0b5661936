// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** The maps of the moment that is held: asked for from the server, the newest wish wins, one question at a time. */
import type { AnswerFrames, HeldMoment, Question } from './model.ts';
import type { PingsEnd, SnapshotEnd } from '../protocol/messages.ts';
import type { MethodMap } from './method_map.ts';

const pingsBefore = 250;
/** Methods that one question may name. */
const mostMethods = 8;

interface Asker {
  ask<T>(question: Question): Promise<T>;
  framesOf(id: number): AnswerFrames | null;
  methodNames(): string[];
  changed(): void;
}

export class HeldMaps {
  moment: HeldMoment | null = null;
  maps: ReadonlyMap<string, MethodMap> | null = null;
  private wanted: number | null = null;
  private busy = false;

  constructor(private readonly asker: Asker) {}

  /** Null: live again. */
  hold(t: number | null): void {
    this.wanted = t;
    if (t === null) {
      const was = this.moment;
      this.moment = null;
      this.maps = null;
      if (was) this.asker.changed();
    } else if (!this.busy) {
      void this.fetch(t);
    }
  }

  private async mapsAt(t: number): Promise<{ end: SnapshotEnd; maps: ReadonlyMap<string, MethodMap> }> {
    const names = this.asker.methodNames();
    const maps = new Map<string, MethodMap>();
    for (let i = 0; ; i += mostMethods) {
      const end = await this.asker.ask<SnapshotEnd>({ type: 'snapshot', t, methods: names.slice(i, i + mostMethods) });
      for (const [method, map] of this.asker.framesOf(end.id)?.maps ?? []) maps.set(method, map);
      if (i + mostMethods >= names.length) return { end, maps };
    }
  }

  private async fetch(t: number): Promise<void> {
    this.busy = true;
    try {
      const { end, maps } = await this.mapsAt(t);
      const from = Math.max(0, end.pings - pingsBefore);
      const count = end.pings - from;
      const pings = count > 0 ? await this.asker.ask<PingsEnd>({ type: 'pings', from, count }) : null;
      if (this.wanted !== null) {
        this.maps = maps;
        this.moment = { t: end.t, pings: end.pings, pose: end.pose, recent: pings ? this.asker.framesOf(pings.id)?.pings ?? [] : [] };
        this.asker.changed();
      }
    } catch {
      // Refused or not connected: what was shown stays, and the next wish asks anew.
    } finally {
      this.busy = false;
    }
    if (this.wanted !== null && this.wanted !== t) void this.fetch(this.wanted);
  }
}
