// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Answers to explain and step, from what the small mapper remembers. */
import { cellM, changes } from './mapping.mjs';
import { rejections, sonar, wallDistance } from './world.mjs';

const outcomes = ['no_echo', 'echo', 'too_close', 'rejected'];

export function detail(p) {
  return {
    ping: p.id, t: p.t, tx: p.k, rx: p.k, range_m: Number.isNaN(p.range) ? null : p.range, outcome: outcomes[p.outcome],
    reason: p.outcome === 3 ? rejections[p.reason] : null, T_world_tx: [p.x, p.y, p.yaw], T_world_rx: [p.x, p.y, p.yaw],
    T_world_robot: p.pose, beam_width: 2 * sonar.half, trusted_range_m: sonar.trustedM,
  };
}

const probability = (l) => 1 / (1 + Math.exp(-l));

function cellHistory(maps, x, y) {
  const [i, j] = [Math.floor(x / cellM), Math.floor(y / cellM)];
  let value = 0;
  const all = [];
  for (const p of maps.pings) {
    if (Math.hypot(p.x - x, p.y - y) > sonar.maxM + 0.1) continue;
    for (const c of changes(p)) {
      if (c.i !== i || c.j !== j) continue;
      all.push({ ping: p.id, t: p.t, sensor: p.k, before: value, after: value + c.d, where: c.d > 0 ? 'on' : Math.abs(c.theta) > sonar.half / 2 ? 'beside' : 'before' });
      value += c.d;
    }
  }
  return { method: 'evidence', i, j, unit: 'log-odds', value, probability: probability(value), changes: all.slice(-6), total: all.length };
}

export function explain(maps, { id, method, slot, x, y }) {
  const r = slot === undefined ? null : maps.points[method]?.records[slot];
  if (slot !== undefined && !r) return null;
  const at = r ?? { x, y };
  const cell = cellHistory(maps, at.x, at.y);
  const base = { type: 'explanation', id, method, x: at.x, y: at.y, cell, searched: maps.pings.length, off_wall_m: wallDistance(at.x, at.y) };
  if (!r) {
    const sentence = `${cell.total} pings changed it. Sum ${cell.value.toFixed(2)}, so p = ${cell.probability.toFixed(2)}.`;
    return { ...base, kind: 'cell', sentence, slot: null, label: '', bound_m: null, probability: cell.probability, own: null, arc: null, support: [], unused: [] };
  }
  const own = r.p;
  const seen = method === 'atm' ? own.crossed : [];
  const support = method === 'carve'
    ? own.cutters.map((p) => ({ ping: detail(p), t: null, angle: null, x: null, y: null, note: 'cut a piece off the arc' }))
    : seen.map((c) => ({ ping: detail(c.ping), t: c.rel, angle: c.angle, x: c.x, y: c.y, note: 'crosses the arc' }));
  const sentence = {
    atm: `Ping ${own.id} heard an echo at ${own.range.toFixed(2)} m, but not from which direction. ${support.length} other arcs cross its arc steeply enough. The point is the median of those crossings.`,
    carve: `${support.length} later pings proved parts of the arc of ping ${own.id} empty. The point is the middle of what is left.`,
    centerline: `The middle of the beam of ping ${own.id}, nothing else.`,
  }[method];
  const unused = method === 'atm' && own.flat > 0 ? [{ reason: 'cross below 13 degrees', count: own.flat }] : [];
  return {
    ...base, kind: 'point', sentence, slot, label: method, bound_m: r.bound, probability: 1, own: detail(own),
    arc: { t: r.rel, t_begin: -sonar.half, t_end: sonar.half, bound_t: 2 * Math.asin(Math.min(0.5, r.bound / (2 * own.range))) }, support, unused,
  };
}

const sym = (text) => ['sym', text];
const val = (name) => ['val', name];
const formulas = [
  { words: 'How far off the axis', result: 'w', tree: ['eq', sym('w'), ['exp', ['neg', ['mul', ['num', 0.5], ['pow', ['frac', val('theta'), val('spread')], ['num', 2]]]]]] },
  { words: 'Chance that this ping means “occupied”', result: 'p', tree: ['eq', sym('p'), val('p')] },
  { words: 'Added to what the cell held before', result: 'after', tree: ['eq', sym('ℓ'), ['add', val('before'), ['ln', ['frac', val('p'), ['sub', ['num', 1], val('p')]]]]] },
];

/** `earlier`: the maps before the ping. */
export function step(maps, earlier, { id, method, ping }) {
  const p = maps.pings[ping];
  if (!p) return null;
  const used = p.outcome !== 3;
  const cells = method !== 'evidence' ? [] : [...changes(p)].map((c) => {
    const before = oddsIn(earlier, c.i, c.j);
    const terms = [['theta', c.theta * 180 / Math.PI, '°'], ['spread', sonar.half * 90 / Math.PI, '°'], ['w', Math.exp(-0.5 * (2 * c.theta / sonar.half) ** 2), ''], ['p', probability(c.d), ''], ['before', before, ''], ['after', before + c.d, '']];
    return { i: c.i, j: c.j, x: (c.i + 0.5) * cellM, y: (c.j + 0.5) * cellM, before, after: before + c.d, terms: terms.map(([name, value, unit]) => ({ name, value, unit })) };
  });
  const arcs = method === 'atm' && p.outcome === 1
    ? p.crossed.map((c) => ({ ping: detail(c.ping), what: 'crossed', x: c.x, y: c.y, t_begin: null, t_end: null, note: `at ${(c.angle * 57.3).toFixed(0)}°` }))
    : [];
  const point = maps.points[method]?.records[p.id];
  return {
    type: 'stepped', id, method, ping: detail(p), used, reason: used ? '' : rejections[p.reason], time_of_flight_s: Number.isNaN(p.range) ? null : (2 * p.range) / 343.3,
    speed_of_sound_m_s: 343.3, true_pose: p.pose.map((v, i) => v + [0.02, -0.015, 0.01][i]),
    arc: p.outcome === 1 ? { length_m: 2 * sonar.half * p.range, t_begin: -sonar.half, t_end: sonar.half } : null,
    cell_m: method === 'evidence' ? cellM : null, unit: method === 'evidence' ? 'log-odds' : '', cells, formulas: cells.length ? formulas : [], arcs,
    points: point ? [[point.x, point.y]] : [], summary: `${cells.filter((c) => c.after > c.before).length} cells get fuller, ${cells.filter((c) => c.after < c.before).length} get emptier.`,
  };
}

function oddsIn(maps, i, j) {
  const [column, row] = [Math.floor(i / 64), Math.floor(j / 64)];
  return maps.cells.get(`${column},${row}`)?.odds[(j - 64 * row) * 64 + i - 64 * column] ?? 0;
}
