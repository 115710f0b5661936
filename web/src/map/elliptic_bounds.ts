// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Bounds of points that one sensor heard of another: pieces of ellipses, which the centre that comes with a point cannot say. */
import type { MethodMap } from '../model/method_map.ts';
import { type EchoArc, placeAt, radiusAt } from './echo_arc.ts';
import { boundHalfAngle } from './scene.ts';

const pieces = 6;
const none = new Float32Array(0);
const known = new WeakMap<MethodMap, { version: number; everyNth: number; segments: Float32Array }>();

/** Segments x0, y0, x1, y1; `arcOf` tells the arc of a ping, null where it is not known any more. */
export function ellipticBounds(map: MethodMap, everyNth: number, arcOf: (ping: number) => EchoArc | null): Float32Array {
  const before = known.get(map);
  if (before?.version === map.version && before.everyNth === everyNth) return before.segments;
  const out: number[] = [];
  for (let i = 0; i < map.slots; i += everyNth) {
    const bound = map.boundM[i] ?? Number.NaN;
    if (!map.alive[i] || !(bound > 0) || !Number.isNaN(map.arcX[i] ?? 0)) continue;
    const arc = arcOf(map.ping[i] ?? 0);
    if (arc && arc.rangeM !== arc.semiMinorM) addPiece(out, arc, map.x[i] ?? 0, map.y[i] ?? 0, bound);
  }
  const segments = out.length === 0 ? none : new Float32Array(out);
  known.set(map, { version: map.version, everyNth, segments });
  return segments;
}

function addPiece(out: number[], arc: EchoArc, x: number, y: number, boundM: number): void {
  const t = Math.atan2(y - arc.y, x - arc.x) - arc.yaw;
  const half = boundHalfAngle(boundM, radiusAt(arc, t));
  let [fromX, fromY] = placeAt(arc, t - half);
  for (let k = 1; k <= pieces; k++) {
    const [toX, toY] = placeAt(arc, t - half + (2 * half * k) / pieces);
    out.push(fromX, fromY, toX, toY);
    [fromX, fromY] = [toX, toY];
  }
}
