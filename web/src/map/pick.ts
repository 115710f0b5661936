// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** What lies under the pointer. */
import { probabilityOf, tileSide } from '../model/map_store.ts';
import type { MethodMap } from '../model/method_map.ts';
import type { PingRecord } from '../model/ping_store.ts';
import type { Camera } from '../model/model.ts';
import type { Area } from './camera.ts';
import { arcDistancePx } from './cones.ts';
import type { Pick } from './map_view.ts';

export const pointReachPx = 8;
export const arcReachPx = 6;
export const cellsFromScale = 90;

export interface PickFrom {
  s: number;
  points: readonly MethodMap[];
  grids: readonly MethodMap[];
  /** Pings whose arcs are drawn, oldest first. */
  arcs: readonly PingRecord[];
  halfAngleOf: (ping: PingRecord) => number;
}

export function pickAt(from: PickFrom, x: number, y: number): Pick | null {
  return nearestPoint(from, x, y) ?? newestArc(from, x, y) ?? (from.s >= cellsFromScale ? cellAt(from.grids, x, y) : null);
}

/** Of points that are as near, the one of the method that is drawn on top. */
function nearestPoint({ points, s }: PickFrom, x: number, y: number): Pick | null {
  let best = (pointReachPx / s) ** 2;
  let found: { map: MethodMap; slot: number } | null = null;
  for (const map of points) {
    for (let i = 0; i < map.slots; i++) {
      if (!map.alive[i]) continue;
      const d = ((map.x[i] ?? 0) - x) ** 2 + ((map.y[i] ?? 0) - y) ** 2;
      if (d < best || (d === best && !found)) {
        best = d;
        found = { map, slot: i };
      }
    }
  }
  return found && pointPick(found.map, found.slot);
}

export type PointPick = Extract<Pick, { kind: 'point' }>;

/** The point after or before `from`, walking outwards from the centre of the view; the nearest when `from` is not in view. */
export function nextPoint(maps: readonly MethodMap[], { x, y, s }: Camera, area: Area, from: PointPick | null, direction: 1 | -1): PointPick | null {
  const reach = Math.min(area.width, area.height) / 2 / s;
  const near: { map: MethodMap; slot: number; d: number }[] = [];
  for (const map of maps) {
    for (let slot = 0; slot < map.slots; slot++) {
      const d = Math.hypot((map.x[slot] ?? 0) - x, (map.y[slot] ?? 0) - y);
      if (map.alive[slot] && d <= reach) near.push({ map, slot, d });
    }
  }
  near.sort((a, b) => a.d - b.d);
  const at = near.findIndex(({ map, slot }) => map.method === from?.method && slot === from.slot);
  const next = near[at < 0 ? 0 : (at + direction + near.length) % near.length];
  return next ? pointPick(next.map, next.slot) : null;
}

export function pointPick(map: MethodMap, slot: number): PointPick {
  return {
    kind: 'point', method: map.method, slot, x: map.x[slot] ?? 0, y: map.y[slot] ?? 0, ping: map.ping[slot] ?? 0,
    boundM: map.boundM[slot] ?? Number.NaN,
  };
}

function newestArc({ arcs, halfAngleOf, s }: PickFrom, x: number, y: number): Pick | null {
  for (let i = arcs.length - 1; i >= 0; i--) {
    const ping = arcs[i];
    if (ping && arcDistancePx(ping, halfAngleOf(ping), x, y, s) <= arcReachPx) return { kind: 'arc', ping, x, y };
  }
  return null;
}

export function cellAt(grids: readonly MethodMap[], x: number, y: number): Pick | null {
  const map = grids.find((candidate) => candidate.grid !== null);
  if (!map?.grid) return null;
  const { cellM, x: x0, y: y0 } = map.grid;
  const i = Math.floor((x - x0) / cellM);
  const j = Math.floor((y - y0) / cellM);
  const [column, row] = [Math.floor(i / tileSide), Math.floor(j / tileSide)];
  const byte = map.tiles.get(`${column},${row}`)?.bytes[(j - row * tileSide) * tileSide + (i - column * tileSide)] ?? 0;
  return { kind: 'cell', method: map.method, i, j, x: x0 + (i + 0.5) * cellM, y: y0 + (j + 0.5) * cellM, probability: probabilityOf(byte) };
}
