// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Which supporting arc lies under the pointer. */
import { arcOfDetail, distanceToArc } from '../map/echo_arc.ts';
import type { Explanation, PingDetail } from '../protocol/messages.ts';

const reachPx = 8;

/** Distance of a place to the arc of a ping. */
export const arcDistance = (ping: PingDetail, x: number, y: number): number => distanceToArc(arcOfDetail(ping), x, y);

/** The ping of the nearest supporting arc, if one is near enough. */
export function arcUnder({ support }: Pick<Explanation, 'support'>, x: number, y: number, pxPerM: number): number | null {
  let best: number | null = null;
  let nearest = reachPx / pxPerM;
  for (const { ping } of support) {
    const d = arcDistance(ping, x, y);
    if (d > nearest) continue;
    nearest = d;
    best = ping.ping;
  }
  return best;
}
