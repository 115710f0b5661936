// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Camera maths: world metres (y up) to CSS pixels (y down) of an area. */
import type { Camera } from '../model/model.ts';
import { scaleRange } from '../model/url_state.ts';

export interface Box { x0: number; y0: number; x1: number; y1: number }
export interface Area { x: number; y: number; width: number; height: number }

export const clampScale = (s: number): number => Math.min(scaleRange.max, Math.max(scaleRange.min, s));

export function pixelOf(camera: Camera, area: Area, x: number, y: number): { px: number; py: number } {
  return { px: area.x + area.width / 2 + (x - camera.x) * camera.s, py: area.y + area.height / 2 - (y - camera.y) * camera.s };
}

export function worldOf(camera: Camera, area: Area, px: number, py: number): { x: number; y: number } {
  return { x: camera.x + (px - area.x - area.width / 2) / camera.s, y: camera.y - (py - area.y - area.height / 2) / camera.s };
}

/** The place under (px, py) stays where it is. */
export function zoomedAt(camera: Camera, area: Area, factor: number, px: number, py: number): Camera {
  const s = clampScale(camera.s * factor);
  const at = worldOf(camera, area, px, py);
  const keep = 1 - camera.s / s;
  return { x: camera.x + (at.x - camera.x) * keep, y: camera.y + (at.y - camera.y) * keep, s };
}

export function panned(camera: Camera, dxPx: number, dyPx: number): Camera {
  return { x: camera.x + dxPx / camera.s, y: camera.y - dyPx / camera.s, s: camera.s };
}

/** The whole box is seen, with a margin. */
export function fitted(box: Box, area: Area, marginPx: number, maxScale = 120): Camera {
  const width = Math.max(1, area.width - 2 * marginPx);
  const height = Math.max(1, area.height - 2 * marginPx);
  const s = Math.min(maxScale, width / Math.max(0.01, box.x1 - box.x0), height / Math.max(0.01, box.y1 - box.y0));
  return { x: (box.x0 + box.x1) / 2, y: (box.y0 + box.y1) / 2, s: clampScale(s) };
}

/** The least move after which the robot is inside the middle half of the area. */
export function followed(camera: Camera, area: Area, x: number, y: number): Camera {
  const halfX = area.width / 4 / camera.s;
  const halfY = area.height / 4 / camera.s;
  return {
    x: Math.min(x + halfX, Math.max(x - halfX, camera.x)), y: Math.min(y + halfY, Math.max(y - halfY, camera.y)), s: camera.s,
  };
}

const flightMs = 300;

/** A flight of 300 ms that slows down towards its end; the scale goes evenly by its logarithm. */
export class Flight {
  constructor(private readonly from: Camera, private readonly to: Camera, private readonly beginMs: number) {}

  at(nowMs: number): { camera: Camera; done: boolean } {
    const u = Math.min(1, Math.max(0, (nowMs - this.beginMs) / flightMs));
    if (u >= 1) return { camera: this.to, done: true };
    const e = 1 - (1 - u) ** 3;
    const mix = (a: number, b: number): number => a + (b - a) * e;
    return {
      camera: { x: mix(this.from.x, this.to.x), y: mix(this.from.y, this.to.y), s: this.from.s * (this.to.s / this.from.s) ** e },
      done: false,
    };
  }
}
