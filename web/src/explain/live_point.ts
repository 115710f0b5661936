// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** The server explains its live maps; slots of a map of the past are of that answer alone. */
import type { MethodMap } from '../model/method_map.ts';

export interface SeenPoint { slot: number; ping: number; x: number; y: number }

/** Slot in the live map of the point that was seen, maybe in a map of the past: the nearest of the same ping; null: it is gone. */
export function liveSlot(live: MethodMap | undefined, { slot, ping, x, y }: SeenPoint): number | null {
  if (!live) return null;
  if (live.alive[slot] && live.ping[slot] === ping && live.x[slot] === x && live.y[slot] === y) return slot;
  let best: number | null = null;
  let nearest = Number.POSITIVE_INFINITY;
  for (let i = 0; i < live.slots; i++) {
    if (!live.alive[i] || live.ping[i] !== ping) continue;
    const d = Math.hypot((live.x[i] ?? 0) - x, (live.y[i] ?? 0) - y);
    if (d >= nearest) continue;
    nearest = d;
    best = i;
  }
  return best;
}
