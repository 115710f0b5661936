// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

import { expect, test } from 'vitest';
import { defaultView } from '../../src/model/defaults.ts';
import { Live } from '../../src/model/live.ts';
import type { ConnectionState, Topic } from '../../src/model/model.ts';
import { Receiver } from '../../src/net/receiver.ts';
import type { Plan, Welcome } from '../../src/protocol/messages.ts';
import { lengthOf, planInWords } from '../../src/ui/plan_words.ts';
import { menuModes, modeEnded, modeNow } from '../../src/words.ts';

const plan = (change: Partial<Plan>): Plan => ({ type: 'plan', strategy: 'gvg', nodes: [], edges: [], path: [], estimate: null, left_out: 0, ...change });

test('a plan in words says what is on the map', () => {
  expect(planInWords(null)).toBe('nothing planned');
  expect(planInWords(plan({}))).toBe('no way planned');
  expect(planInWords(plan({ nodes: [{ at: [0, 0], kind: 'frontier' }, { at: [1, 0], kind: 'goal' }], path: [[0, 0], [3, 4], [3, 5]] }))).toBe('1 frontier, 6.0 m ahead');
  expect(planInWords(plan({ nodes: [{ at: [0, 0], kind: 'meet' }, { at: [1, 0], kind: 'meet' }, { at: [1, 0], kind: 'boundary' }] }))).toBe('2 meet points, 1 dead end');
});

test('a path of one point, or none, has no length', () => {
  expect(lengthOf([])).toBe(0);
  expect(lengthOf([[1, 2]])).toBe(0);
});

test('the menu lists what is announced, in its order, and driving never', () => {
  expect(menuModes(['stand', 'drive', 'tour', 'frontier', 'goto', 'gvg', 'home'])).toEqual(['frontier', 'gvg', 'goto', 'home', 'tour', 'stand']);
  expect(menuModes(['dance', 'stand'])).toEqual(['stand', 'dance']);
  expect(menuModes([])).toEqual([]);
  expect([modeNow('wall-left'), modeNow('dance')]).toEqual(['Following the left wall', 'Dance']);
});

test('how a strategy ended is said with its reason', () => {
  expect(modeEnded('frontier', true, 'no frontier is left')).toBe('Explore frontiers: done, no frontier is left');
  expect(modeEnded('goto', false, '')).toBe('Go to point: given up');
});

test('the newest plan is kept until none drives, or another server welcomes', () => {
  const live = new Live({} as ConnectionState);
  const told: Topic[] = [];
  const receiver = new Receiver(live, (topic) => told.push(topic), () => []);
  receiver.message(plan({ path: [[1, 2]] }));
  expect(live.plan?.path).toEqual([[1, 2]]);
  receiver.message(plan({ strategy: '' }));
  expect(live.plan).toBeNull();
  receiver.message(plan({}));
  receiver.message({ type: 'welcome', version: '1', session: 's' } as Welcome);
  expect(live.plan).toBeNull();
  expect(told.filter((topic) => topic === 'plan')).toHaveLength(3);
});

test('the plan is shown unless it was switched off', () => {
  expect(defaultView(false).layers).toContain('plan');
});
