// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** How a cell's chance of being occupied becomes a tone: towards `free` evenly, towards `occ` with its square. */
import { probabilityOf } from '../model/map_store.ts';

export const freeSpan = 0.42;
export const occupiedSpan = 0.45;
/** Where points are drawn over the cells, these stay pale so that the points carry the walls. */
export const paleTone = 0.42;

export type Rgb = readonly [number, number, number];

/** -1 free ... 0 unknown ... 1 occupied. */
export function rampOf(probability: number): number {
  if (Number.isNaN(probability)) return 0;
  if (probability <= 0.5) return -Math.min(1, (0.5 - probability) / freeSpan);
  return Math.min(1, (probability - 0.5) / occupiedSpan) ** 2;
}

export function cellColour(byte: number, tone: number, unknown: Rgb, free: Rgb, occupied: Rgb): Rgb {
  const t = rampOf(probabilityOf(byte));
  const [towards, share] = t < 0 ? [free, -t] : [occupied, t * tone];
  const mix = (i: 0 | 1 | 2): number => unknown[i] + (towards[i] - unknown[i]) * share;
  return [mix(0), mix(1), mix(2)];
}

/** Bytes as the graphics card filters them: unknown lies in the middle, else a wall beside it would shine through as free. */
export function filterable(bytes: Uint8Array, into: Uint8Array): Uint8Array {
  for (let i = 0; i < bytes.length; i++) into[i] = bytes[i] || 128;
  return into;
}
