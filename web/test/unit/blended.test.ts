// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

import { describe, expect, test } from 'vitest';
import { blendedColour, onCellsOf } from '../../src/map/blended.ts';
import type { ColourName, Palette } from '../../src/map/palette.ts';
import { cellAt } from '../../src/map/pick.ts';
import { cellColour, type Rgb } from '../../src/map/ramp.ts';
import { MapStore } from '../../src/model/map_store.ts';

const rgb = { unk: [0.9, 0.9, 0.9], free: [1, 1, 1], occ: [0.1, 0.1, 0.1], fuller: [0.7, 0.3, 0], emptier: [0.2, 0.4, 0.7] } as unknown as Record<ColourName, Rgb>;
const palette = { rgb } as Palette;
const [unknown, free, occupied] = [0, 1, 255];
const near = (a: Rgb, b: Rgb): void => { for (const i of [0, 1, 2] as const) expect(a[i]).toBeCloseTo(b[i], 12); };

describe('two grids over one another', () => {
  test('in the middle the colours say who holds a cell occupied', () => {
    near(blendedColour(occupied, occupied, 0.5, palette), rgb.occ);
    near(blendedColour(occupied, free, 0.5, palette), rgb.fuller);
    near(blendedColour(free, occupied, 0.5, palette), rgb.emptier);
    near(blendedColour(unknown, occupied, 0.5, palette), rgb.emptier);
    near(blendedColour(free, unknown, 0.5, palette), rgb.free);
    near(blendedColour(unknown, unknown, 0.5, palette), rgb.unk);
  });

  test('at either end one of them is alone, as it is drawn by itself', () => {
    for (const a of [0, 1, 60, 128, 200, 255]) {
      for (const b of [0, 1, 60, 128, 200, 255]) {
        near(blendedColour(a, b, 0, palette), cellColour(a, 1, rgb.unk, rgb.free, rgb.occ));
        near(blendedColour(a, b, 1, palette), cellColour(b, 1, rgb.unk, rgb.free, rgb.occ));
      }
    }
  });

  test('which comes first decides the colour alone', () => {
    const swapped = { rgb: { ...rgb, fuller: rgb.emptier, emptier: rgb.fuller } } as Palette;
    for (const [a, b] of [[10, 240], [0, 180], [200, 255]] as const) near(blendedColour(a, b, 0.5, palette), blendedColour(b, a, 0.5, swapped));
  });
});

function grid(name: string, cellM: number, x: number, y: number): MapStore {
  const map = new MapStore(name, name);
  map.grid = { cellM, x, y };
  return map;
}

test('a grid of other cells is looked up at the middle of each', () => {
  const [fine, coarse] = [grid('fine', 0.05, 0, 0), grid('coarse', 0.12, -0.7, 0.3)];
  const bytes = new Uint8Array(64 * 64).map((_, i) => (i * 37) % 256);
  fine.setTile(-1, 0, bytes);
  fine.setTile(0, 0, bytes.slice().reverse());
  const moved = onCellsOf(fine, coarse);
  let looked = 0;
  for (let i = -40; i < 40; i++) {
    for (let j = -40; j < 40; j++) {
      const [x, y] = [-0.7 + (i + 0.5) * 0.12, 0.3 + (j + 0.5) * 0.12];
      const [is, was] = [cellAt([moved], x, y), cellAt([fine], x, y)];
      if (is?.kind !== 'cell' || was?.kind !== 'cell') throw new Error('no cell');
      if (Number.isNaN(was.probability)) expect(is.probability).toBeNaN();
      else expect(is.probability).toBeCloseTo(was.probability, 12);
      looked += Number.isNaN(was.probability) ? 0 : 1;
    }
  }
  expect(looked).toBeGreaterThan(800);
  expect(onCellsOf(fine, grid('same', 0.05, 0, 0))).toBe(fine);
  expect(onCellsOf(fine, coarse)).toBe(moved);
  fine.setTile(3, 3, bytes);
  expect(onCellsOf(fine, coarse)).not.toBe(moved);
});
