// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Binary frames as docs/protocol.md describes them. */
import { sonar } from './world.mjs';

function head(kind, method, reset, count, size, id, sequence = 0) {
  const buffer = Buffer.alloc(16 + size * count);
  buffer.writeUInt8(kind, 0);
  buffer.writeUInt8(method, 1);
  buffer.writeUInt16LE(reset ? 1 : 0, 2);
  buffer.writeUInt32LE(count, 4);
  buffer.writeUInt32LE(sequence, 8);
  buffer.writeUInt32LE(id, 12);
  return buffer;
}

export function pingFrame(pings, id = 0) {
  const b = head(1, 0, false, pings.length, 64, id);
  pings.forEach((p, n) => {
    const at = 16 + 64 * n;
    b.writeDoubleLE(p.t, at);
    b.writeUInt32LE(p.id, at + 8);
    b.writeUInt16LE(p.k, at + 12);
    b.writeUInt16LE(p.k, at + 14);
    const floats = [p.range, p.x, p.y, p.yaw, p.x, p.y, p.yaw, ...p.pose, sonar.trustedM];
    floats.forEach((f, i) => b.writeFloatLE(f, at + 16 + 4 * i));
    b.writeUInt8(p.outcome, at + 60);
    b.writeUInt8(p.reason, at + 61);
  });
  return b;
}

export function tileFrame(method, tiles, reset, sequence, id = 0) {
  const b = head(2, method, reset, tiles.length, 8 + 4096, id, sequence);
  tiles.forEach((tile, n) => {
    const at = 16 + 4104 * n;
    b.writeInt32LE(tile.column, at);
    b.writeInt32LE(tile.row, at + 4);
    tile.odds.forEach((l, k) => b.writeUInt8(l === 0 ? 0 : 1 + Math.round(254 / (1 + Math.exp(-l))), at + 8 + k));
  });
  return b;
}

export function pointFrame(method, slots, records, reset, sequence, id = 0) {
  const b = head(3, method, reset, slots.length, 44, id, sequence);
  slots.forEach((slot, n) => {
    const at = 16 + 44 * n;
    const r = records[slot];
    b.writeUInt32LE(slot, at);
    if (!r) { b.writeUInt8(1, at + 39); return; }
    [r.x, r.y, r.bound, r.p.x, r.p.y, 1, r.p.t].forEach((f, i) => b.writeFloatLE(f, at + 4 + 4 * i));
    b.writeUInt32LE(r.p.id, at + 32);
    b.writeUInt16LE(r.p.k, at + 36);
    b.writeUInt8(method, at + 38);
    b.writeUInt32LE(r.support, at + 40);
  });
  return b;
}

export function pathFrame(pairs, reset) {
  const b = head(5, 0, reset, pairs.length, 8, 0);
  pairs.forEach(([x, y], n) => { b.writeFloatLE(x, 16 + 8 * n); b.writeFloatLE(y, 20 + 8 * n); });
  return b;
}
