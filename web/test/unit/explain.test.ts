// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

import { describe, expect, test } from 'vitest';
import { arcDistance, arcUnder } from '../../src/explain/arc_hit.ts';
import { cellBars, type CellHistory } from '../../src/explain/cell_bars.ts';
import { arcFigure, figureSize, labelPlace } from '../../src/explain/figure.ts';
import { type Support, orderedSupport, supportTable } from '../../src/explain/support_table.ts';
import { cellState, words } from '../../src/explain/words.ts';
import type { Explanation, PingDetail } from '../../src/protocol/messages.ts';

const detail = (ping: number, change: Partial<PingDetail> = {}): PingDetail => ({
  ping, t: ping / 10, tx: 3, rx: 3, range_m: 1, outcome: 'echo', reason: null, T_world_tx: [0, 0, 0], T_world_rx: [0, 0, 0], T_world_robot: [0, 0, 0],
  beam_width: 0.4, trusted_range_m: 3, ...change,
});
const support = (ping: number, change: Partial<Support> = {}): Support => ({ ping: detail(ping), t: null, angle: null, x: null, y: null, note: '', ...change });
const explanation = (change: Partial<Explanation> = {}): Explanation => ({
  type: 'explanation', id: 1, method: 'atm', kind: 'point', sentence: '', x: 1, y: 0, slot: 0, label: 'atm', bound_m: 0.04, probability: null, off_wall_m: null,
  own: detail(9), arc: { t: 0.1, t_begin: -0.2, t_end: 0.2, bound_t: 0.05 }, support: [], unused: [], cell: null, searched: 10, ...change,
});

describe('figure along the arc', () => {
  const { width, margin } = figureSize;

  test('its ends are the beam, its middle the axis', () => {
    const figure = arcFigure(explanation());
    expect(figure?.limit).toBe(0.2);
    expect(figure?.whole).toEqual({ x0: margin, x1: width - margin });
    expect(figure?.left).toEqual(figure?.whole);
    expect(figure?.axis).toBeCloseTo(width / 2, 9);
    expect(figure?.point).toBeCloseTo(width / 2 + (width - 2 * margin) / 4, 9);
    expect(figure?.bound?.x0).toBeCloseTo(width / 2 + (width - 2 * margin) / 8, 9);
  });

  test('what is cut off is outside of what is left', () => {
    const figure = arcFigure(explanation({ arc: { t: 0, t_begin: -0.1, t_end: 0.15, bound_t: null } }));
    expect(figure?.left.x0).toBeGreaterThan(margin);
    expect(figure?.left.x1).toBeLessThan(width - margin);
    expect(figure?.bound).toBeNull();
  });

  test('crossings and cuts are told apart, and nothing lies outside', () => {
    const figure = arcFigure(explanation({ support: [support(1, { t: -9, angle: 0.3 }), support(2, { t: 0.1 }), support(3)] }));
    expect(figure?.marks).toEqual([{ ping: 1, kind: 'crossing', x: margin }, { ping: 2, kind: 'cut', x: figure?.point }]);
  });

  test('an arc wider than the beam still fits', () => expect(arcFigure(explanation({ arc: { t: 0.5, t_begin: -0.6, t_end: 0.6, bound_t: 0.1 } }))?.limit).toBe(0.6));

  test('no arc, no figure', () => {
    expect(arcFigure(explanation({ arc: null }))).toBeNull();
    expect(arcFigure(explanation({ own: null }))).toBeNull();
  });

  test('labels stay inside', () => {
    expect(labelPlace(0, 40)).toBe(40);
    expect(labelPlace(width, 40)).toBe(width - 40);
    expect(labelPlace(150, 40)).toBe(150);
  });
});

describe('table of supporting pings', () => {
  test('crossings come along the arc', () => {
    const rows = [support(1, { t: 0.1, angle: 0.3 }), support(2, { t: -0.1, angle: 0.4 }), support(3, { t: 0, angle: 0.5 })];
    expect(orderedSupport(rows).map((s) => s.ping.ping)).toEqual([2, 3, 1]);
    const table = supportTable(rows);
    expect(table?.columns).toEqual(['ping', 'sensor', 'range', 'bearing', 'angle']);
    expect(table?.rows[0]?.cells).toEqual(['2', '3', '1.00 m', '−5.7°', '23°']);
    expect(table?.title).toBe('3 crossings used');
  });

  test('cuts come in time', () => {
    const rows = [support(7, { t: 0.1, note: 'cut 4.2° on the left' }), support(2, { t: 0.2, note: 'cut 1.0° on the right' })];
    const table = supportTable(rows);
    expect(table?.rows.map((r) => r.ping)).toEqual([2, 7]);
    expect(table?.columns).toEqual(['ping', 'sensor', 'range', 'did']);
    expect(table?.title).toBe('2 pings cut its arc');
  });

  test('what speaks without a place keeps its order', () => {
    const table = supportTable([support(7, { note: 'loud' }), support(2, { note: 'quiet' })]);
    expect(table?.rows.map((r) => r.ping)).toEqual([7, 2]);
    expect(table?.title).toBe('2 pings behind it');
  });

  test('a note that only some crossings have is a legend', () => {
    const table = supportTable([support(1, { t: 0, angle: 1, note: 'its crossing is in the middle' }), support(2, { t: 1, angle: 1 })]);
    expect(table?.rows.map((r) => r.strong)).toEqual([true, false]);
    expect(table?.legend).toBe('Bold: its crossing is in the middle.');
  });

  test('two sensors are both named, and no support is no table', () => {
    expect(supportTable([{ ...support(1), ping: detail(1, { tx: 2, rx: 5, range_m: null }) }])?.rows[0]?.cells).toEqual(['1', '2 → 5', '–']);
    expect(supportTable([])).toBeNull();
  });
});

describe('bars of a cell', () => {
  const history = (deltas: number[], unit = 'log-odds'): CellHistory => {
    let value = 0;
    const changes = deltas.map((d, i) => { const before = value; value += d; return { ping: i, t: i, sensor: 1, before, after: value, where: d > 0 ? 'on' as const : 'before' as const }; });
    return { method: 'evidence', i: 0, j: 0, unit, value, probability: 0.5, changes, total: deltas.length };
  };

  test('the newest six, in shares of the largest', () => {
    const bars = cellBars(history([9, 1, -0.5, 0.25, 1, 1, 2]));
    expect(bars.map((b) => b.ping)).toEqual([1, 2, 3, 4, 5, 6]);
    expect(bars.map((b) => b.share)).toEqual([0.5, 0.25, 0.125, 0.5, 0.5, 1]);
    expect(bars[1]?.text).toBe('−0.50');
    expect(bars[5]?.text).toBe('+2.00');
  });

  test('counts are whole', () => expect(cellBars(history([1, 1], 'arcs')).map((b) => b.text)).toEqual(['+1', '+1']));
  test('evidence for free empties', () => {
    expect(cellBars(history([1, -1], 'evidence')).map((b) => b.isFuller)).toEqual([false, true]);
    expect(cellBars(history([1, -1])).map((b) => b.isFuller)).toEqual([true, false]);
  });
  test('no change, no bar', () => expect(cellBars(history([]))).toEqual([]));
  test('changes of nothing have no length', () => expect(cellBars(history([0]))[0]?.share).toBe(0));

  test('the line below says how many', () => {
    expect(words.latest(6, 14)).toBe('Latest 6 of 14 pings that changed it');
    expect(words.latest(3, 3)).toBe('All 3 pings that changed it');
    expect(words.latest(1, 1)).toBe('The one ping that changed it');
    expect(words.sum(2.512)).toBe('; sum +2.51');
  });
});

describe('arc under the pointer', () => {
  test('distance to the arc and to its ends', () => {
    expect(arcDistance(detail(1), 1.5, 0)).toBeCloseTo(0.5, 9);
    expect(arcDistance(detail(1), 0, 0)).toBeCloseTo(1, 9);
    expect(arcDistance(detail(1), Math.cos(0.2), Math.sin(0.2))).toBeCloseTo(0, 9);
    expect(arcDistance(detail(1), 0, 1)).toBeCloseTo(Math.hypot(Math.cos(0.2), 1 - Math.sin(0.2)), 9);
    expect(arcDistance(detail(1, { T_world_tx: [0, 0, Math.PI], T_world_rx: [0, 0, -Math.PI] }), -1, 0)).toBeCloseTo(0, 9);
  });

  test('the nearest within eight pixels', () => {
    const all = [support(1), { ...support(2), ping: detail(2, { range_m: 1.05 }) }];
    expect(arcUnder({ support: all }, 1.03, 0, 100)).toBe(2);
    expect(arcUnder({ support: all }, 1.01, 0, 100)).toBe(1);
    expect(arcUnder({ support: all }, 1.2, 0, 100)).toBeNull();
  });
});

test('a cell is occupied, free or unknown', () => {
  expect([null, 0.5, 0.92, 0.1].map(cellState)).toEqual(['unknown', 'unknown', 'occupied', 'free']);
});
