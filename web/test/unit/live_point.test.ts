// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

import { expect, test } from 'vitest';
import { liveSlot } from '../../src/explain/live_point.ts';
import { MapStore } from '../../src/model/map_store.ts';

test('a point of a map of the past is found again on the live one by its ping', () => {
  const live = new MapStore('atm', 'atm');
  const point = { boundM: 0, arcX: 0, arcY: 0, probability: 1, time: 0, sensor: 0, label: 0, flags: 0, support: 0 };
  live.setPoint({ ...point, slot: 0, ping: 7, x: 1, y: 1 });
  live.setPoint({ ...point, slot: 1, ping: 9, x: 2, y: 2 });
  live.setPoint({ ...point, slot: 2, ping: 9, x: 5, y: 5 });
  live.setPoint({ ...point, slot: 3, ping: 11, x: 3, y: 3, flags: 1 });
  expect(liveSlot(live, { slot: 1, ping: 9, x: 2, y: 2 })).toBe(1);
  expect(liveSlot(live, { slot: 0, ping: 9, x: 4.5, y: 5 })).toBe(2); // that slot is another point there
  expect(liveSlot(live, { slot: 3, ping: 11, x: 3, y: 3 })).toBeNull();
  expect(liveSlot(undefined, { slot: 0, ping: 7, x: 1, y: 1 })).toBeNull();
});
