// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

import { Answers } from '../net/answers.ts';
import type { Counters, DriveLost, DriveRequest, Error as Refusal, Methods, Plan, Recompute, Scores, State, Viewers, Welcome } from '../protocol/messages.ts';
import { emptyTimeline } from './history.ts';
import type { MapStore } from './map_store.ts';
import type { ConnectionState, ScoreSeries, Timeline } from './model.ts';
import { PingRing } from './ping_ring.ts';

/** All that came over the wire; written by the receiver alone. */
export class Live {
  welcome: Welcome | null = null;
  state: State | null = null;
  plan: Plan | null = null;
  counters: Counters | null = null;
  methods: Methods | null = null;
  scores: Scores | null = null;
  scoreHistory = new Map<string, ScoreSeries>();
  viewers: Viewers | null = null;
  timeline: Timeline = emptyTimeline();
  recompute = new Map<string, Recompute>();
  driveRequest: DriveRequest | null = null;
  driveLost: DriveLost | null = null;
  refused: Refusal | null = null;
  readonly pings = new PingRing();
  readonly maps = new Map<string, MapStore>();
  readonly answers = new Answers();
  path = new Float32Array(1024);
  pathLength = 0;
  laser: Float32Array = new Float32Array(0);

  constructor(readonly connection: ConnectionState) {}

  appendPath(pairs: Float32Array): void {
    const needed = this.pathLength + pairs.length;
    if (needed > this.path.length) {
      const larger = new Float32Array(2 ** Math.ceil(Math.log2(needed)));
      larger.set(this.path.subarray(0, this.pathLength));
      this.path = larger;
    }
    this.path.set(pairs, this.pathLength);
    this.pathLength = needed;
  }
}
