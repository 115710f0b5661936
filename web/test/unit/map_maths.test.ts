// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

import { expect, test } from 'vitest';
import { MapStore } from '../../src/model/map_store.ts';
import { fitted, Flight, followed, panned, pixelOf, worldOf, zoomedAt } from '../../src/map/camera.ts';
import { crossSegments } from '../../src/map/crosses.ts';
import { pickAt, type PickFrom } from '../../src/map/pick.ts';
import { cellColour, filterable, rampOf } from '../../src/map/ramp.ts';
import { crossStep, scaleBar } from '../../src/map/scale_bar.ts';
import { boundHalfAngle } from '../../src/map/scene.ts';
import { everyNth, sideAreas } from '../../src/map/scene_builder.ts';
import { markSlots } from '../../src/map/slots.ts';
import type { Methods } from '../../src/protocol/messages.ts';
import { ping } from './made_up.ts';

const area = { x: 100, y: 50, width: 800, height: 600 };
const camera = { x: 2, y: -1, s: 40 };

test('pixels and metres are each other\'s inverse, y up', () => {
  expect(pixelOf(camera, area, 3, 0)).toEqual({ px: 540, py: 310 });
  const { px, py } = pixelOf(camera, area, -4.3, 7.1);
  expect(worldOf(camera, area, px, py)).toEqual({ x: expect.closeTo(-4.3, 9) as number, y: expect.closeTo(7.1, 9) as number });
});

test('zoom keeps the place under the pointer, also at its ends', () => {
  for (const factor of [0.1, 0.5, 2, 1000]) {
    const before = worldOf(camera, area, 333, 222);
    const zoomed = zoomedAt(camera, area, factor, 333, 222);
    const after = worldOf(zoomed, area, 333, 222);
    expect([after.x, after.y]).toEqual([expect.closeTo(before.x, 9), expect.closeTo(before.y, 9)]);
    expect(zoomed.s).toBeGreaterThanOrEqual(8);
    expect(zoomed.s).toBeLessThanOrEqual(600);
  }
});

test('pan, fit and follow', () => {
  expect(panned(camera, 40, 80)).toEqual({ x: 3, y: -3, s: 40 });
  expect(fitted({ x0: 0, y0: 0, x1: 10, y1: 2 }, area, 50)).toEqual({ x: 5, y: 1, s: 70 });
  expect(fitted({ x0: 1, y0: 1, x1: 1, y1: 1 }, area, 50).s).toBe(120);
  expect(followed(camera, area, 4, -2)).toEqual(camera); // within the middle half: 5 m and 3.75 m
  expect(followed(camera, area, 9, -1)).toEqual({ x: 4, y: -1, s: 40 });
});

test('a flight begins and ends where it should, and ends', () => {
  const flight = new Flight(camera, { x: 5, y: 5, s: 160 }, 1000);
  expect(flight.at(1000).camera).toEqual(camera);
  expect(flight.at(1150).done).toBe(false);
  expect(flight.at(1300)).toEqual({ camera: { x: 5, y: 5, s: 160 }, done: true });
});

test('the scale bar is the first round length of 60 px, and crosses get finer', () => {
  expect([600, 300, 120, 62, 45, 8].map((s) => scaleBar(s).label)).toEqual(['10 cm', '20 cm', '50 cm', '1 m', '2 m', '10 m']);
  expect(scaleBar(62).lengthPx).toBe(62);
  expect([10, 20, 50, 100, 400].map(crossStep)).toEqual([5, 2, 1, 1, 0.1]);
  expect(crossSegments({ x: 0, y: 0, s: 50 }, { x: 0, y: 0, width: 110, height: 110 }).length).toBe(9 * 8);
  // A ruler of decimetres at two edges: 11 and 6 ticks beside 2 x 1 crosses, the metres twice as long.
  const ruled = crossSegments({ x: 0.5, y: 0.25, s: 100 }, { x: 0, y: 0, width: 110, height: 60 });
  expect(ruled.length).toBe(2 * 8 + (11 + 6) * 4);
  const lengths = [...Array(11).keys()].map((i) => Math.round(100 * ((ruled[16 + 4 * i + 3] ?? 0) - (ruled[16 + 4 * i + 1] ?? 0))));
  expect(lengths).toEqual([8, 4, 4, 4, 4, 4, 4, 4, 4, 4, 8]);
});

test('the ramp: unknown between, free evenly, occupied by its square', () => {
  expect([Number.NaN, 0.5, 0, 0.08, 0.29, 1, 0.95].map((p) => rampOf(p) + 0)).toEqual([0, 0, -1, -1, expect.closeTo(-0.5, 9), 1, expect.closeTo(1, 9)]);
  expect(rampOf(0.725)).toBeCloseTo(0.25, 9);
  const colour = (byte: number, tone: number) => cellColour(byte, tone, [0.5, 0.5, 0.5], [1, 1, 1], [0, 0, 0])[0];
  expect([colour(0, 1), colour(1, 1), colour(255, 1), colour(255, 0.42)]).toEqual([0.5, 1, 0, expect.closeTo(0.29, 9)]);
  expect([...filterable(Uint8Array.of(0, 1, 255), new Uint8Array(3))]).toEqual([128, 1, 255]);
});

test('a bound on an arc is the chord that it may be off', () => {
  expect(boundHalfAngle(0.1, 1)).toBeCloseTo(2 * Math.asin(0.05), 12);
  expect(boundHalfAngle(100, 1)).toBeCloseTo(Math.PI / 3, 12);
  expect(boundHalfAngle(Number.NaN, 1)).toBeNaN();
});

function pickFrom(s: number): PickFrom {
  const atm = new MapStore('atm');
  const base = { boundM: 0.1, arcX: 0, arcY: 0, probability: 1, time: 0, sensor: 0, label: 0, flags: 0, support: 1 };
  atm.setPoint({ ...base, slot: 0, x: 1, y: 1, ping: 5 });
  atm.setPoint({ ...base, slot: 1, x: 1.05, y: 1, ping: 6 });
  atm.setPoint({ ...base, slot: 2, x: 3, y: 3, ping: 7, flags: 1 });
  const grid = new MapStore('evidence');
  grid.grid = { cellM: 0.1, x: -1, y: -1 };
  const bytes = new Uint8Array(4096);
  bytes[64 * 30 + 40] = 255;
  grid.setTile(0, 0, bytes);
  return { s, points: [atm], grids: [grid], arcs: [ping(1, { rangeM: 2 }), ping(2, { rangeM: 2.01 })], halfAngleOf: () => 0.2 };
}

test('picking: the nearest point, else the newest arc, else a cell when it is large', () => {
  expect(pickAt(pickFrom(100), 1.04, 1)).toMatchObject({ kind: 'point', slot: 1, ping: 6 });
  expect(pickAt(pickFrom(100), 1.0, 1.07)).toMatchObject({ kind: 'point', slot: 0 });
  expect(pickAt(pickFrom(100), 2.005, 0.02)).toMatchObject({ kind: 'arc', ping: { id: 2 } });
  expect(pickAt(pickFrom(100), 3.05, 2.05)).toMatchObject({ kind: 'cell', method: 'evidence', i: 40, j: 30, probability: 1 });
  expect(pickAt(pickFrom(100), -50, 2)).toMatchObject({ kind: 'cell', i: -490, probability: Number.NaN });
  expect(pickAt(pickFrom(50), 3.05, 2.05)).toBeNull();
  expect(pickAt(pickFrom(100), 3, 3)?.kind).toBe('cell'); // the point there is gone
});

const methods = (...names: string[]): Methods => ({
  type: 'methods', running: names.map((method) => ({ method, name: method, label: method, options: {}, state: 'ok', reason: '', grid: null, points: true })),
});

test('marks are the same whatever is shown', () => {
  expect([...markSlots(methods('centerline', 'carve', 'atm'), [])].sort()).toEqual([['atm', 1], ['carve', 2], ['centerline', 3]]);
  expect([...markSlots(methods('centerline', 'carve', 'atm', 'consensus'), [])].sort()).toEqual([['atm', 4], ['carve', 2], ['centerline', 3], ['consensus', 1]]);
  expect(markSlots(methods('vt', 'dm', 'centerline'), ['dm', 'vt'])).toEqual(new Map([['centerline', 3], ['dm', 1], ['vt', 2]]));
});

test('panes and thinning', () => {
  expect(sideAreas(3, 100, 60).map((a) => [a.x, a.y, a.width, a.height])).toEqual([[0, 0, 50, 30], [50, 0, 50, 30], [0, 30, 50, 30]]);
  expect(sideAreas(2, 100, 60)[1]).toEqual({ x: 50, y: 0, width: 50, height: 60 });
  expect([everyNth(40_000, 10), everyNth(120_000, 10), everyNth(120_000, 40)]).toEqual([1, 3, 1]);
});
