// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

import type { MethodMap, Tile } from './method_map.ts';

export const tileSide = 64;
export const slotFlag = { empty: 1, provisional: 2 } as const;
/** No method has as many points; a slot beyond is a damaged frame and must not fill the memory. */
export const slotLimit = 4_000_000;

export interface PointRecord {
  slot: number; x: number; y: number; boundM: number; arcX: number; arcY: number; probability: number; time: number;
  ping: number; sensor: number; label: number; flags: number; support: number;
}

type Column = Uint8Array | Uint16Array | Uint32Array | Float32Array;

function grown<C extends Column>(column: C, length: number): C {
  const larger = new (column.constructor as new (n: number) => C)(length);
  larger.set(column);
  return larger;
}

/** The one MethodMap that can be written; a point is written in place, arrays double when a slot lies beyond. */
export class MapStore implements MethodMap {
  grid: { cellM: number; x: number; y: number } | null = null;
  tiles = new Map<string, Tile>();
  slots = 0;
  alive = new Uint8Array(0);
  x = new Float32Array(0);
  y = new Float32Array(0);
  boundM = new Float32Array(0);
  arcX = new Float32Array(0);
  arcY = new Float32Array(0);
  probability = new Float32Array(0);
  time = new Float32Array(0);
  ping = new Uint32Array(0);
  sensor = new Uint16Array(0);
  label = new Uint8Array(0);
  flags = new Uint8Array(0);
  support = new Uint32Array(0);
  points = 0;
  version = 0;

  constructor(readonly method: string, public name = method) {}

  setTile(column: number, row: number, bytes: Uint8Array): void {
    const key = `${column},${row}`;
    this.version++;
    if (bytes.every((b) => b === 0)) this.tiles.delete(key);
    else this.tiles.set(key, { column, row, bytes, version: this.version });
  }

  setPoint(p: PointRecord): void {
    if (p.slot >= slotLimit) return;
    if (p.slot >= this.alive.length) this.grow(p.slot + 1);
    const i = p.slot;
    const alive = (p.flags & slotFlag.empty) === 0 ? 1 : 0;
    this.points += alive - (this.alive[i] ?? 0);
    this.slots = Math.max(this.slots, i + 1);
    this.alive[i] = alive;
    this.x[i] = p.x;
    this.y[i] = p.y;
    this.boundM[i] = p.boundM;
    this.arcX[i] = p.arcX;
    this.arcY[i] = p.arcY;
    this.probability[i] = p.probability;
    this.time[i] = p.time;
    this.ping[i] = p.ping;
    this.sensor[i] = p.sensor;
    this.label[i] = p.label;
    this.flags[i] = p.flags;
    this.support[i] = p.support;
    this.version++;
  }

  clearTiles(): void {
    this.tiles.clear();
    this.version++;
  }

  clearPoints(): void {
    this.alive.fill(0);
    this.slots = 0;
    this.points = 0;
    this.version++;
  }

  private grow(needed: number): void {
    const length = Math.max(1024, 2 ** Math.ceil(Math.log2(needed)));
    this.alive = grown(this.alive, length);
    this.x = grown(this.x, length);
    this.y = grown(this.y, length);
    this.boundM = grown(this.boundM, length);
    this.arcX = grown(this.arcX, length);
    this.arcY = grown(this.arcY, length);
    this.probability = grown(this.probability, length);
    this.time = grown(this.time, length);
    this.ping = grown(this.ping, length);
    this.sensor = grown(this.sensor, length);
    this.label = grown(this.label, length);
    this.flags = grown(this.flags, length);
    this.support = grown(this.support, length);
  }
}

/** Chance that a cell is occupied, of its byte; NaN: unknown. */
export function probabilityOf(byte: number): number { return byte === 0 ? Number.NaN : (byte - 1) / 254; }
