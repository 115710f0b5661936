// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

import { expect, test } from 'vitest';
import { MapStore, probabilityOf, type PointRecord } from '../../src/model/map_store.ts';
import { eachPoint, pairsOf, pingsOf, readFrame, tilesOf } from '../../src/net/frames.ts';

function frame(kind: number, records: Uint8Array[], head: { method?: number; flags?: number; id?: number; sequence?: number } = {}): ArrayBuffer {
  const size = records.reduce((sum, r) => sum + r.length, 16);
  const buffer = new ArrayBuffer(size);
  const view = new DataView(buffer);
  view.setUint8(0, kind);
  view.setUint8(1, head.method ?? 0);
  view.setUint16(2, head.flags ?? 0, true);
  view.setUint32(4, records.length, true);
  view.setUint32(8, head.sequence ?? 0, true);
  view.setUint32(12, head.id ?? 0, true);
  let at = 16;
  for (const record of records) {
    new Uint8Array(buffer).set(record, at);
    at += record.length;
  }
  return buffer;
}

const bytesOf = (hex: string): Uint8Array => Uint8Array.from(hex.replaceAll(' ', '').match(/../g) ?? [], (two) => Number.parseInt(two, 16));
function read(buffer: ArrayBuffer) {
  const found = readFrame(buffer);
  if (!found) throw new Error('no frame');
  return found;
}

test('a ping, byte by byte', () => {
  const record = bytesOf(
    '000000000000f83f' // t = 1.5
    + '2a000000 0300 0400' // id 42, receiver 3, transmitter 4
    + '0000403f' // range 0.75
    + '0000803f 00000040 00004040' // transmitter 1, 2, 3
    + '00000000 000080bf 0000003f' // receiver 0, -1, 0.5
    + '0000803e 0000803f 00000000' // robot 0.25, 1, 0
    + 'cdcccc3f' // trusted to 1.6
    + '03 02 0000');
  const [ping] = [...pingsOf(read(frame(1, [record])))];
  expect(ping).toMatchObject({
    t: 1.5, id: 42, rx: 3, tx: 4, rangeM: 0.75, txX: 1, txY: 2, txYaw: 3, rxX: 0, rxY: -1, rxYaw: 0.5, robotX: 0.25, robotY: 1, robotYaw: 0,
    outcome: 'rejected', reason: 2,
  });
  expect(ping?.trustedM).toBeCloseTo(1.6, 6);
});

test('an outcome that is not known counts as rejected, a range that is not there is NaN', () => {
  const record = new Uint8Array(64);
  new DataView(record.buffer).setFloat32(16, Number.NaN, true);
  record[60] = 9;
  const [ping] = [...pingsOf(read(frame(1, [record])))];
  expect(ping?.outcome).toBe('rejected');
  expect(ping?.rangeM).toBeNaN();
});

test('tiles keep their bytes when the frame is gone, and a tile of zeros is no longer there', () => {
  const record = new Uint8Array(8 + 4096);
  new DataView(record.buffer).setInt32(0, -2, true);
  new DataView(record.buffer).setInt32(4, 7, true);
  record[8] = 255;
  record[8 + 4095] = 1;
  const buffer = frame(2, [record], { method: 3, flags: 1, sequence: 12 });
  const found = read(buffer);
  expect(found).toMatchObject({ method: 3, reset: true, sequence: 12 });
  const map = new MapStore('evidence');
  for (const { column, row, bytes } of tilesOf(found)) map.setTile(column, row, bytes);
  new Uint8Array(buffer).fill(0);
  const tile = map.tiles.get('-2,7');
  expect([tile?.bytes[0], tile?.bytes[1], tile?.bytes[4095]]).toEqual([255, 0, 1]);
  map.setTile(-2, 7, new Uint8Array(4096));
  expect(map.tiles.size).toBe(0);
  expect([probabilityOf(0), probabilityOf(1), probabilityOf(255)]).toEqual([Number.NaN, 0, 1]);
});

test('a point, byte by byte', () => {
  const record = bytesOf('05000000 0000803f 00000040 cdcc4c3d 00000000 0000c03f 0000003f 00002041 09000000 0600 01 02 07000000');
  const points: PointRecord[] = [];
  eachPoint(read(frame(3, [record])), (p) => points.push({ ...p }));
  expect(points).toEqual([{
    slot: 5, x: 1, y: 2, boundM: expect.closeTo(0.05, 6) as number, arcX: 0, arcY: 1.5, probability: 0.5, time: 10, ping: 9, sensor: 6, label: 1, flags: 2,
    support: 7,
  }]);
});

test('pairs of the path', () => {
  expect([...pairsOf(read(frame(5, [bytesOf('0000803f 00000040'), bytesOf('00004040 00008040')])))]).toEqual([1, 2, 3, 4]);
});

test('a frame whose length is not what its head says is refused', () => {
  const good = frame(5, [new Uint8Array(8)]);
  expect(readFrame(good)).not.toBeNull();
  expect(readFrame(good.slice(0, 23))).toBeNull();
  expect(readFrame(new ArrayBuffer(3))).toBeNull();
  expect(readFrame(frame(9, []))).toBeNull();
  const lying = frame(3, []);
  new DataView(lying).setUint32(4, 4_000_000_000, true);
  expect(readFrame(lying)).toBeNull();
});
