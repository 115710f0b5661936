// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

import { expect, test } from 'vitest';
import { appendScores, applyBins, emptyTimeline } from '../../src/model/history.ts';
import { MapStore, type PointRecord, slotLimit } from '../../src/model/map_store.ts';
import { PingRing } from '../../src/model/ping_ring.ts';
import { ping } from './made_up.ts';

const point = (slot: number, change: Partial<PointRecord> = {}): PointRecord => ({
  slot, x: slot, y: 2, boundM: 0.1, arcX: 0, arcY: 0, probability: 1, time: 0, ping: slot, sensor: 1, label: 0, flags: 0, support: 2, ...change,
});

test('points keep their slots, also when the arrays grow', () => {
  const map = new MapStore('atm');
  for (let i = 0; i < 5000; i++) map.setPoint(point(i));
  expect([map.points, map.slots, map.x[4999], map.x[7]]).toEqual([5000, 5000, 4999, 7]);
  map.setPoint(point(7, { flags: 1 }));
  map.setPoint(point(7, { flags: 1 }));
  expect([map.points, map.alive[7]]).toEqual([4999, 0]);
  map.setPoint(point(7, { x: 3.5 }));
  expect([map.points, map.x[7]]).toEqual([5000, 3.5]);
  map.clearPoints();
  expect([map.points, map.slots]).toEqual([0, 0]);
});

test('a slot beyond all reason is not made room for', () => {
  const map = new MapStore('atm');
  map.setPoint(point(slotLimit + 1));
  expect([map.points, map.alive.length]).toEqual([0, 0]);
});

test('the ping store is bounded, finds by id and by sensor, and takes nothing twice', () => {
  const ring = new PingRing(1000);
  for (let i = 0; i < 5000; i++) ring.add(ping(i));
  expect(ring.recent.length).toBeLessThanOrEqual(1000);
  expect(ring.newest?.id).toBe(4999);
  expect(ring.add(ping(4999))).toBe(false);
  expect(ring.byId(4500)?.id).toBe(4500);
  expect(ring.byId(3)).toBeNull();
  const own = ring.ofSensor(2, 490);
  expect(own.map((p) => p.id)).toEqual(Array.from({ length: 25 }, (_, i) => 4902 + 4 * i));
  expect(ring.ofSensor(77, 0)).toEqual([]);
});

test('bins of the timeline are written where they belong', () => {
  const timeline = emptyTimeline();
  applyBins(timeline, { type: 'timeline', first: 2, echoes: [5, 6], no_echoes: [1, 1], rejected: [0, 2] });
  applyBins(timeline, { type: 'timeline', first: 3, echoes: [9], no_echoes: [2], rejected: [3] });
  expect(timeline).toMatchObject({ echoes: [0, 0, 5, 9], noEchoes: [0, 0, 1, 2], rejected: [0, 0, 0, 3] });
});

test('scores of a replay that was wound back replace those after it', () => {
  const series = new Map();
  const scores = (t: number, mae: number | null) => ({
    type: 'scores' as const, t, reason: '', methods: [{ method: 'atm', points: 1, bound_m: null, mae_m: mae, p95_m: null, found: null, cpu_ms_per_ping: null }],
  });
  for (const [t, mae] of [[1, 0.1], [2, 0.2], [3, null], [2, 0.4]] as const) appendScores(series, scores(t, mae));
  expect(series.get('atm')).toEqual({ t: [1, 2], maeM: [0.1, 0.4] });
});
