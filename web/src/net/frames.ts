// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Binary frames: docs/protocol.md says what is where. A frame whose length is not what its head announces is refused whole. */
import { type PointRecord, tileSide } from '../model/map_store.ts';
import { outcomes, type PingRecord } from '../model/ping_store.ts';

export const frameKind = { pings: 1, tiles: 2, points: 3, laser: 4, path: 5 } as const;
const headBytes = 16;
const tileBytes = tileSide * tileSide;
const recordBytes: Record<number, number> = {
  [frameKind.pings]: 64, [frameKind.tiles]: 8 + tileBytes, [frameKind.points]: 44, [frameKind.laser]: 8, [frameKind.path]: 8,
};

export interface Frame {
  kind: number;
  /** Index in the last `methods` message; of an answer: among the methods that the question names. */
  method: number;
  /** Forget all of this kind, and method, before it. */
  reset: boolean;
  records: number;
  sequence: number;
  /** Question that it answers; 0: live. */
  id: number;
  body: DataView;
}

export function readFrame(buffer: ArrayBuffer): Frame | null {
  if (buffer.byteLength < headBytes) return null;
  const head = new DataView(buffer, 0, headBytes);
  const kind = head.getUint8(0);
  const records = head.getUint32(4, true);
  const size = recordBytes[kind];
  if (size === undefined || buffer.byteLength !== headBytes + size * records) return null;
  return {
    kind, records, method: head.getUint8(1), reset: (head.getUint16(2, true) & 1) !== 0, sequence: head.getUint32(8, true),
    id: head.getUint32(12, true), body: new DataView(buffer, headBytes),
  };
}

export function* pingsOf({ body, records }: Frame): Generator<PingRecord> {
  for (let i = 0, at = 0; i < records; i++, at += 64) {
    const f32 = (offset: number): number => body.getFloat32(at + offset, true);
    yield {
      t: body.getFloat64(at, true), id: body.getUint32(at + 8, true), rx: body.getUint16(at + 12, true),
      tx: body.getUint16(at + 14, true), rangeM: f32(16), txX: f32(20), txY: f32(24), txYaw: f32(28), rxX: f32(32), rxY: f32(36),
      rxYaw: f32(40), robotX: f32(44), robotY: f32(48), robotYaw: f32(52), trustedM: f32(56),
      outcome: outcomes[body.getUint8(at + 60)] ?? 'rejected', reason: body.getUint8(at + 61),
    };
  }
}

export function* tilesOf({ body, records }: Frame): Generator<{ column: number; row: number; bytes: Uint8Array }> {
  const size = 8 + tileBytes;
  for (let at = 0; at < records * size; at += size) {
    // A copy: a view would keep the whole frame alive for one tile.
    const bytes = new Uint8Array(body.buffer, body.byteOffset + at + 8, tileBytes).slice();
    yield { column: body.getInt32(at, true), row: body.getInt32(at + 4, true), bytes };
  }
}

/** Calls `put` with the same record every time: points come by the ten thousand. */
export function eachPoint({ body, records }: Frame, put: (point: PointRecord) => void): void {
  const p: PointRecord = {
    slot: 0, x: 0, y: 0, boundM: 0, arcX: 0, arcY: 0, probability: 0, time: 0, ping: 0, sensor: 0, label: 0, flags: 0, support: 0,
  };
  for (let i = 0, at = 0; i < records; i++, at += 44) {
    p.slot = body.getUint32(at, true);
    p.x = body.getFloat32(at + 4, true);
    p.y = body.getFloat32(at + 8, true);
    p.boundM = body.getFloat32(at + 12, true);
    p.arcX = body.getFloat32(at + 16, true);
    p.arcY = body.getFloat32(at + 20, true);
    p.probability = body.getFloat32(at + 24, true);
    p.time = body.getFloat32(at + 28, true);
    p.ping = body.getUint32(at + 32, true);
    p.sensor = body.getUint16(at + 36, true);
    p.label = body.getUint8(at + 38);
    p.flags = body.getUint8(at + 39);
    p.support = body.getUint32(at + 40, true);
    put(p);
  }
}

/** Kinds 4 and 5: x, y, x, y, ... */
export function pairsOf({ body, records }: Frame): Float32Array<ArrayBuffer> {
  const out = new Float32Array(2 * records);
  for (let i = 0; i < out.length; i++) out[i] = body.getFloat32(4 * i, true);
  return out;
}
