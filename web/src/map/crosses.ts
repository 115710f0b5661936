// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

import type { Camera } from '../model/model.ts';
import type { Area } from './camera.ts';
import { crossStep } from './scale_bar.ts';

const armPx = 3;

/** Segments of the crosses that are seen, x0, y0, x1, y1 in metres; snapped so that they are sharp. */
export function crossSegments(camera: Camera, area: Area): Float32Array {
  const step = crossStep(camera.s);
  const halfX = area.width / 2 / camera.s;
  const halfY = area.height / 2 / camera.s;
  const [i0, i1] = [Math.ceil((camera.x - halfX) / step), Math.floor((camera.x + halfX) / step)];
  const [j0, j1] = [Math.ceil((camera.y - halfY) / step), Math.floor((camera.y + halfY) / step)];
  const out = new Float32Array(8 * Math.max(0, i1 - i0 + 1) * Math.max(0, j1 - j0 + 1));
  const arm = armPx / camera.s;
  let n = 0;
  for (let i = i0; i <= i1; i++) {
    for (let j = j0; j <= j1; j++) {
      const x = snapped(i * step, camera.x, camera.s, area.width);
      const y = snapped(j * step, camera.y, camera.s, area.height);
      out.set([x - arm, y, x + arm, y, x, y - arm, x, y + arm], n);
      n += 8;
    }
  }
  return out;
}

/** The nearest place whose pixel has its middle there. */
function snapped(at: number, centre: number, s: number, size: number): number {
  const px = Math.round((at - centre) * s + size / 2 - 0.5) + 0.5;
  return centre + (px - size / 2) / s;
}
