// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Which supporting arc lies under the pointer. */
import type { Explanation, PingDetail } from '../protocol/messages.ts';

const reachPx = 8;
const turn = 2 * Math.PI;

/** Distance of a place to the arc of a ping; with two sensors to that about their middle, as it is drawn. */
export function arcDistance({ T_world_tx: a, T_world_rx: b, range_m, trusted_range_m, beam_width }: PingDetail, x: number, y: number): number {
  const r = range_m ?? trusted_range_m;
  const [cx, cy] = [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
  const yaw = Math.atan2(Math.sin(a[2]) + Math.sin(b[2]), Math.cos(a[2]) + Math.cos(b[2]));
  const off = ((Math.atan2(y - cy, x - cx) - yaw + 3 * Math.PI) % turn + turn) % turn - Math.PI;
  const t = Math.max(-beam_width / 2, Math.min(beam_width / 2, off));
  return Math.hypot(cx + r * Math.cos(yaw + t) - x, cy + r * Math.sin(yaw + t) - y);
}

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
