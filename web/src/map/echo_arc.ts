// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/**
 * Where the echo of a ping may have come from: the arc of constant path from transmitter to receiver. One sensor: a circle;
 * two: an ellipse with them as foci. Both by the bearing from the centre, the sensor or the middle of the two, off the
 * axis ([Barshan07] section 2). Metres and radians.
 */
import type { PingRecord } from '../model/ping_store.ts';
import type { PingDetail } from '../protocol/messages.ts';

export interface EchoArc {
  /** Centre. */
  x: number;
  y: number;
  /** Bearing of the axis, and half of the beam about it. */
  yaw: number;
  half: number;
  /** Half of the path, the semi-major axis; the radius of a circle. */
  rangeM: number;
  semiMinorM: number;
  /** Bearing from transmitter to receiver; of no meaning for a circle. */
  focal: number;
}

type Pose = readonly [x: number, y: number, yaw: number];
export type Place = readonly [x: number, y: number];

/** A path that is no longer than the way between the sensors has no ellipse: a circle about their middle stands for it. */
export function echoArc(tx: Pose, rx: Pose, rangeM: number, half: number): EchoArc {
  const [dx, dy] = [rx[0] - tx[0], rx[1] - tx[1]];
  const semiFocal = Math.hypot(dx, dy) / 2;
  const minor = rangeM > semiFocal ? Math.sqrt((rangeM - semiFocal) * (rangeM + semiFocal)) : rangeM;
  const yaw = tx[2] === rx[2] ? tx[2] : Math.atan2(Math.sin(tx[2]) + Math.sin(rx[2]), Math.cos(tx[2]) + Math.cos(rx[2]));
  return { x: (tx[0] + rx[0]) / 2, y: (tx[1] + rx[1]) / 2, yaw, half, rangeM, semiMinorM: minor, focal: Math.atan2(dy, dx) };
}

export const arcOfRecord = (p: PingRecord, rangeM: number, half: number): EchoArc => echoArc([p.txX, p.txY, p.txYaw], [p.rxX, p.rxY, p.rxYaw], rangeM, half);

export const arcOfDetail = (p: PingDetail): EchoArc => echoArc(p.T_world_tx, p.T_world_rx, p.range_m ?? p.trusted_range_m, p.beam_width / 2);

/** Distance from the centre at `t` off the axis. */
export function radiusAt({ yaw, rangeM: a, semiMinorM: b, focal }: EchoArc, t: number): number {
  if (a === b) return a;
  const u = yaw + t - focal;
  return (a * b) / Math.hypot(b * Math.cos(u), a * Math.sin(u));
}

export function placeAt(arc: EchoArc, t: number): Place {
  const r = radiusAt(arc, t);
  return [arc.x + r * Math.cos(arc.yaw + t), arc.y + r * Math.sin(arc.yaw + t)];
}

/** Angle from which an ellipse is drawn: x = a cos e, y = b sin e along and across the focal axis. */
export function eccentric({ yaw, rangeM: a, semiMinorM: b, focal }: EchoArc, t: number): number {
  const u = yaw + t - focal;
  return a === b ? u : Math.atan2(a * Math.sin(u), b * Math.cos(u));
}

/** Distance of a place to the arc, by the nearest bearing on it. */
export function distanceToArc(arc: EchoArc, x: number, y: number): number {
  const off = Math.atan2(y - arc.y, x - arc.x) - arc.yaw;
  const bearing = Math.atan2(Math.sin(off), Math.cos(off));
  const [nearX, nearY] = placeAt(arc, Math.max(-arc.half, Math.min(arc.half, bearing)));
  return Math.hypot(x - nearX, y - nearY);
}
