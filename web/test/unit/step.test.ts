// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

import { describe, expect, test } from 'vitest';
import { type Cell, cellAfter, cellRank, chosenCell, firstCell, pingAfter } from '../../src/step/cells.ts';
import { lastPart, nextPart, partLines } from '../../src/step/parts.ts';
import { beforeAfter, reasonText } from '../../src/step/words.ts';
import type { Stepped } from '../../src/protocol/messages.ts';

const cell = (i: number, j: number, before: number, after: number): Cell => ({ i, j, x: i, y: j, before, after, terms: [] });
const stepped = (change: Partial<Stepped> = {}): Stepped => ({
  type: 'stepped', id: 1, method: 'evidence', used: true, reason: '', time_of_flight_s: 0.00839, speed_of_sound_m_s: 343.3, true_pose: null,
  arc: { length_m: 0.63, t_begin: -0.2, t_end: 0.2 }, cell_m: 0.1, unit: 'log-odds', cells: [cell(1, 1, 0, 0.5), cell(2, 1, 0, -0.5), cell(1, 2, 0, -0.4)], formulas: [],
  arcs: [], points: [], summary: '',
  ping: {
    ping: 5, t: 86.52, tx: 5, rx: 5, range_m: 1.44, outcome: 'echo', reason: null, T_world_tx: [7.98, 8.16, 1.5586], T_world_rx: [7.98, 8.16, 1.5586],
    T_world_robot: [8, 8, 0], beam_width: 0.4, trusted_range_m: 3,
  }, ...change,
});

describe('lines of the five steps', () => {
  test('of an echo on a grid', () => {
    const lines = partLines(stepped());
    expect(lines.map((l) => l.value)).toEqual(['8.39 ms', '7.98, 8.16 m', '63 cm long', '3 cells', '']);
    expect(lines[0]?.line + (lines[0]?.strong ?? '')).toBe('½ · 343.3 m/s · 8.39 ms = 1.44 m');
    expect(lines[1]?.line).toBe('Facing 89.3° when it fired');
    expect(lines[3]?.line).toBe('1 cell gets fuller, 2 cells get emptier');
  });

  test('a rejected ping ends with the first', () => {
    const s = stepped({ used: false, reason: 'cross-talk', ping: { ...stepped().ping, outcome: 'rejected', reason: 'cross-talk' } });
    expect(lastPart(s)).toBe(1);
    expect(partLines(s).map((l) => l.value)).toEqual(['rejected', 'not used', 'not used', 'not used', 'not used']);
    expect(partLines({ ...s, arc: null })[2]?.title).toBe('The arc');
    expect(nextPart(s, 1)).toBeNull();
  });

  test('silence clears, and a method may have no use for it', () => {
    const s = stepped({ used: false, reason: 'silence says nothing to this method', time_of_flight_s: null, arc: null, ping: { ...stepped().ping, outcome: 'no_echo', range_m: null } });
    expect(partLines(s).map((l) => l.value)).toEqual(['silence', '7.98, 8.16 m', 'up to 3.00 m', 'not used', 'not used']);
    expect(partLines(s)[0]?.title).toBe('No echo');
  });

  test('methods of arcs tell what they meet', () => {
    const arc = (what: 'crossed' | 'cut' | 'removed'): Stepped['arcs'][number] => ({ ping: stepped().ping, what, x: null, y: null, t_begin: null, t_end: null, note: '' });
    const title = (...all: ('crossed' | 'cut' | 'removed')[]): string => partLines(stepped({ cell_m: null, cells: [], arcs: all.map(arc) }))[3]?.title ?? '';
    expect(title('crossed')).toBe('The arcs it crosses');
    expect(title('cut', 'removed')).toBe('The arcs it cuts');
    expect(title('crossed', 'cut')).toBe('The arcs it crosses and cuts');
    expect(title()).toBe('What it adds to the map');
  });

  test('the next step is named', () => {
    expect([1, 2, 3, 4, 5].map((part) => nextPart(stepped(), part))).toEqual(['the sensor', 'the arc', 'the cells', 'the map after it', null]);
  });
});

describe('cells', () => {
  const { cells } = stepped();

  test('the one that grows most is looked at first', () => {
    expect(firstCell(cells, 'log-odds')).toBe(cells[0]);
    expect(firstCell(cells.slice(1), 'log-odds')).toBe(cells[1]);
    expect(firstCell([], 'log-odds')).toBeNull();
  });

  test('the one asked for, if it changed', () => {
    expect(chosenCell(cells, { i: 1, j: 2 }, 'log-odds')).toBe(cells[2]);
    expect(chosenCell(cells, { i: 9, j: 9 }, 'log-odds')).toBe(cells[0]);
    expect(chosenCell(cells, null, 'log-odds')).toBe(cells[0]);
  });

  test('evidence counts for free space: more of it is emptier', () => {
    expect(firstCell(cells, 'evidence')).toBe(cells[1]);
    expect(partLines(stepped({ unit: 'evidence' }))[3]?.line).toBe('2 cells get fuller, 1 cell gets emptier');
    expect(beforeAfter(8.1, 8.2, 'evidence')).toEqual({ before: '8.10 before, ', after: '8.20 evidence for free' });
  });

  test('one after the other in rows, and around', () => {
    expect(cellAfter(cells, { i: 1, j: 1 }, 1)).toBe(cells[1]);
    expect(cellAfter(cells, { i: 1, j: 2 }, 1)).toBe(cells[0]);
    expect(cellAfter(cells, { i: 1, j: 1 }, -1)).toBe(cells[2]);
    expect(cellRank(cells, { i: 1, j: 2 })).toBe(3);
  });
});

test('pings stay within the log', () => {
  expect(pingAfter(5, -16, 100)).toBe(0);
  expect(pingAfter(95, 16, 100)).toBe(99);
  expect(pingAfter(5, 1, 100)).toBe(6);
  expect(pingAfter(0, 1, 0)).toBe(0);
});

test('before and after in the words of the unit', () => {
  expect(beforeAfter(1.61, 2.51, 'log-odds')).toEqual({ before: '83% occupied before, ', after: '92%' });
  expect(beforeAfter(0.5, 0.25, 'p')).toEqual({ before: '50% occupied before, ', after: '25%' });
  expect(beforeAfter(3, 4, 'arcs')).toEqual({ before: '3 before, ', after: '4 arcs' });
});

test('reasons are sentences', () => {
  expect(reasonText('range_jump')).toBe('Range jump.');
  expect(reasonText('It is off.')).toBe('It is off.');
});
