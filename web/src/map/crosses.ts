// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

import type { Camera } from '../model/model.ts';
import type { Area } from './camera.ts';
import { crossStep } from './scale_bar.ts';

const armPx = 3;
const tickPx = 4;
const tickM = 0.1;
/** Below, decimetres are too narrow; above, the crosses have their distance. */
const [ticksFromScale, ticksToScale] = [90, 340];

/** Segments of the crosses that are seen and of the ticks, x0, y0, x1, y1 in metres; snapped so that they are sharp. */
export function crossSegments(camera: Camera, area: Area): Float32Array {
  const step = crossStep(camera.s);
  const columns = seen(camera.x, area.width / 2 / camera.s, step);
  const rows = seen(camera.y, area.height / 2 / camera.s, step);
  const ticks = tickSegments(camera, area);
  const out = new Float32Array(8 * columns.length * rows.length + ticks.length);
  const arm = armPx / camera.s;
  let n = 0;
  for (const i of columns) {
    for (const j of rows) {
      const x = snapped(i * step, camera.x, camera.s, area.width);
      const y = snapped(j * step, camera.y, camera.s, area.height);
      out.set([x - arm, y, x + arm, y, x, y - arm, x, y + arm], n);
      n += 8;
    }
  }
  out.set(ticks, n);
  return out;
}

/** A ruler of decimetres along the lower and the left edge, longer at whole metres, where a metre is too long to guess by. */
function tickSegments(camera: Camera, area: Area): number[] {
  const { x, y, s } = camera;
  if (s < ticksFromScale || s >= ticksToScale) return [];
  const [halfX, halfY] = [area.width / 2 / s, area.height / 2 / s];
  const [left, bottom] = [x - halfX, y - halfY];
  const out: number[] = [];
  const length = (i: number): number => (i % 10 === 0 ? 2 * tickPx : tickPx) / s;
  for (const i of seen(x, halfX, tickM)) {
    const at = snapped(i * tickM, x, s, area.width);
    out.push(at, bottom, at, bottom + length(i));
  }
  for (const j of seen(y, halfY, tickM)) {
    const at = snapped(j * tickM, y, s, area.height);
    out.push(left, at, left + length(j), at);
  }
  return out;
}

/** Multiples of a step within half a width of the centre. */
function seen(centre: number, half: number, step: number): number[] {
  const first = Math.ceil((centre - half) / step);
  return Array.from({ length: Math.max(0, Math.floor((centre + half) / step) - first + 1) }, (_, i) => first + i);
}

/** The nearest place whose pixel has its middle there. */
function snapped(at: number, centre: number, s: number, size: number): number {
  const px = Math.round((at - centre) * s + size / 2 - 0.5) + 0.5;
  return centre + (px - size / 2) / s;
}
