// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

import { describe, expect, test } from 'vitest';
import { ellipticBounds } from '../../src/map/elliptic_bounds.ts';
import { distanceToArc, eccentric, echoArc, placeAt, radiusAt } from '../../src/map/echo_arc.ts';
import { MapStore } from '../../src/model/map_store.ts';

const two = echoArc([0, 0, 0.2], [0.3, 0.1, 0.4], 1.2, 0.5);

describe('the arc of an echo', () => {
  test('of one sensor is a circle about it', () => {
    const one = echoArc([1, 2, 0.5], [1, 2, 0.5], 2, 0.3);
    expect(one).toMatchObject({ x: 1, y: 2, yaw: 0.5, rangeM: 2, semiMinorM: 2 });
    expect(placeAt(one, 0.3)[0]).toBeCloseTo(1 + 2 * Math.cos(0.8), 12);
  });

  test('of two has the same path everywhere', () => {
    for (let t = -0.5; t <= 0.5; t += 0.05) {
      const [x, y] = placeAt(two, t);
      expect(Math.hypot(x, y) + Math.hypot(x - 0.3, y - 0.1)).toBeCloseTo(2.4, 12);
    }
    expect(two.yaw).toBeCloseTo(0.3, 12);
  });

  test('is drawn where it is: the eccentric angle leads to the same place', () => {
    for (const t of [-0.5, -0.1, 0, 0.3, 0.5]) {
      const e = eccentric(two, t);
      const [u, v] = [two.rangeM * Math.cos(e), two.semiMinorM * Math.sin(e)];
      const [x, y] = placeAt(two, t);
      expect(two.x + u * Math.cos(two.focal) - v * Math.sin(two.focal)).toBeCloseTo(x, 12);
      expect(two.y + u * Math.sin(two.focal) + v * Math.cos(two.focal)).toBeCloseTo(y, 12);
    }
  });

  test('lies between the axes of its ellipse', () => {
    for (let t = -3; t <= 3; t += 0.1) {
      expect(radiusAt(two, t)).toBeLessThanOrEqual(two.rangeM + 1e-12);
      expect(radiusAt(two, t)).toBeGreaterThanOrEqual(two.semiMinorM - 1e-12);
    }
  });

  test('a path shorter than the way between the sensors is a circle, not nothing', () => {
    expect(placeAt(echoArc([0, 0, 0], [1, 0, 0], 0.4, 0.2), 0)).toEqual([0.9, 0]);
  });

  test('its distance is none on it, and that of its end beyond it', () => {
    const [x, y] = placeAt(two, 0.2);
    expect(distanceToArc(two, x, y)).toBeCloseTo(0, 12);
    const [endX, endY] = placeAt(two, 0.5);
    const [beyondX, beyondY] = placeAt(two, 0.9);
    expect(distanceToArc(two, beyondX, beyondY)).toBeCloseTo(Math.hypot(beyondX - endX, beyondY - endY), 12);
  });
});

test('bounds of points between two sensors lie on their ellipse, as long as the bound says', () => {
  const map = new MapStore('atm', 'atm');
  const [x, y] = placeAt(two, 0.1);
  const point = { slot: 0, x, y, boundM: 0.08, arcX: Number.NaN, arcY: Number.NaN, probability: 1, time: 0, ping: 4, sensor: 1, label: 0, flags: 0, support: 2 };
  map.setPoint(point);
  map.setPoint({ ...point, slot: 1, arcX: 0, arcY: 0 }); // of a circle: its centre came along
  map.setPoint({ ...point, slot: 2, ping: 5 }); // of a ping that is no longer known
  const segments = ellipticBounds(map, 1, (ping) => (ping === 4 ? two : null));
  expect(segments.length).toBe(6 * 4);
  let length = 0;
  for (let i = 0; i < segments.length; i += 4) {
    const [x0, y0, x1, y1] = segments.slice(i, i + 4) as unknown as [number, number, number, number];
    expect(Math.hypot(x1, y1) + Math.hypot(x1 - 0.3, y1 - 0.1)).toBeCloseTo(2.4, 5);
    length += Math.hypot(x1 - x0, y1 - y0);
  }
  expect(length).toBeGreaterThan(0.155);
  expect(length).toBeLessThan(0.165);
  expect(ellipticBounds(map, 1, () => null)).toBe(segments); // nothing changed
});
