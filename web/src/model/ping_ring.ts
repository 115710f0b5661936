// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

import type { PingRecord, PingStore } from './ping_store.ts';

const slack = 0.9; // what is left when the bound is reached, so that not every ping moves the whole array

/** The newest pings, oldest first, at most `capacity`. Ids only ever grow, so they are found by bisection. */
export class PingRing implements PingStore {
  private pings: PingRecord[] = [];
  private readonly sensors = new Map<number, PingRecord[]>();

  constructor(private readonly capacity = 20_000) {}

  get recent(): readonly PingRecord[] { return this.pings; }
  get newest(): PingRecord | null { return this.pings.at(-1) ?? null; }

  /** False for one that is here already, as after a reconnect. */
  add(ping: PingRecord): boolean {
    const last = this.newest;
    if (last && ping.id <= last.id) return false;
    this.pings.push(ping);
    const own = this.sensors.get(ping.rx);
    if (own) own.push(ping);
    else this.sensors.set(ping.rx, [ping]);
    if (this.pings.length > this.capacity) this.trim();
    return true;
  }

  clear(): void {
    this.pings = [];
    this.sensors.clear();
  }

  byId(id: number): PingRecord | null {
    const found = this.pings[firstFrom(this.pings, (p) => p.id >= id)];
    return found?.id === id ? found : null;
  }

  ofSensor(sensor: number, sinceT: number): PingRecord[] {
    const own = this.sensors.get(sensor) ?? [];
    return own.slice(firstFrom(own, (p) => p.t >= sinceT));
  }

  private trim(): void {
    this.pings.splice(0, this.pings.length - Math.floor(slack * this.capacity));
    const oldest = this.pings[0]?.id ?? 0;
    for (const own of this.sensors.values()) own.splice(0, firstFrom(own, (p) => p.id >= oldest));
  }
}

/** Index of the first that holds, in an array where all that do come after all that do not. */
export function firstFrom<T>(sorted: readonly T[], holds: (item: T) => boolean): number {
  let low = 0;
  let high = sorted.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (holds(sorted[middle] as T)) high = middle;
    else low = middle + 1;
  }
  return low;
}
