// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Two grids over one another: what both hold occupied, what the first alone, and what the second alone. */
import { MapStore, probabilityOf, tileSide } from '../model/map_store.ts';
import type { MethodMap } from '../model/method_map.ts';
import type { Palette } from './palette.ts';
import { cellAt } from './pick.ts';
import { rampOf, type Rgb } from './ramp.ts';

const mixed = (a: Rgb, b: Rgb, share: number): Rgb => [a[0] + (b[0] - a[0]) * share, a[1] + (b[1] - a[1]) * share, a[2] + (b[2] - a[2]) * share];

/** `blend`: 0 the first alone, 0.5 where they agree and where not, 1 the second alone. */
export function blendedColour(first: number, second: number, blend: number, { rgb }: Palette): Rgb {
  const [a, b] = [rampOf(probabilityOf(first)), rampOf(probabilityOf(second))];
  const alone = (t: number): Rgb => (t < 0 ? mixed(rgb.unk, rgb.free, -t) : mixed(rgb.unk, rgb.occ, t));
  const [oa, ob] = [Math.max(0, a), Math.max(0, b)];
  const ground = mixed(rgb.unk, rgb.free, Math.max(0, -a, -b));
  const [more, colour] = oa > ob ? [oa - ob, rgb.fuller] : [ob - oa, rgb.emptier];
  const one = (i: 0 | 1 | 2): number => ground[i] * (1 - Math.max(oa, ob)) + rgb.occ[i] * Math.min(oa, ob) + colour[i] * more;
  const both: Rgb = [one(0), one(1), one(2)];
  return blend < 0.5 ? mixed(alone(a), both, 2 * blend) : mixed(both, alone(b), 2 * blend - 1);
}

const resampled = new WeakMap<MethodMap, { version: number; to: string; map: MethodMap }>();

/** A grid on the cells of another: itself where these are the same, else each cell what lies at its middle. */
export function onCellsOf(map: MethodMap, other: MethodMap): MethodMap {
  const [own, to] = [map.grid, other.grid];
  if (!own || !to || (own.cellM === to.cellM && own.x === to.x && own.y === to.y)) return map;
  const key = `${to.cellM} ${to.x} ${to.y}`;
  const known = resampled.get(map);
  if (known?.version === map.version && known.to === key) return known.map;
  const made = new MapStore(`${map.method} on ${other.method}`);
  made.grid = { ...to };
  for (const place of tilesUnder(map, to)) {
    const bytes = new Uint8Array(tileSide * tileSide);
    for (let k = 0; k < bytes.length; k++) {
      const x = to.x + (place.column * tileSide + (k % tileSide) + 0.5) * to.cellM;
      const y = to.y + (place.row * tileSide + Math.floor(k / tileSide) + 0.5) * to.cellM;
      const found = cellAt([map], x, y);
      if (found?.kind === 'cell' && !Number.isNaN(found.probability)) bytes[k] = 1 + Math.round(254 * found.probability);
    }
    made.setTile(place.column, place.row, bytes);
  }
  resampled.set(map, { version: map.version, to: key, map: made });
  return made;
}

type Grid = NonNullable<MethodMap['grid']>;

/** Tiles of a grid that those of a map reach into. */
function tilesUnder(map: MethodMap, to: Grid): { column: number; row: number }[] {
  const side = (map.grid?.cellM ?? 0) * tileSide;
  const toSide = to.cellM * tileSide;
  const found = new Map<string, { column: number; row: number }>();
  for (const tile of map.tiles.values()) {
    const x = (map.grid?.x ?? 0) + tile.column * side - to.x;
    const y = (map.grid?.y ?? 0) + tile.row * side - to.y;
    for (let column = Math.floor(x / toSide); column * toSide < x + side; column++)
      for (let row = Math.floor(y / toSide); row * toSide < y + side; row++) found.set(`${column},${row}`, { column, row });
  }
  return [...found.values()];
}
