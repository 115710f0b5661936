// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Four mapping methods in short: centerline, arc median, carving, and a grid of log-odds. */
import { sonar, wallDistance, wrap } from './world.mjs';

const leastCrossing = (13 * Math.PI) / 180;
const guard = 0.025;
const remembered = 250;
const samples = 41;
export const cellM = 0.05;

const onArc = (p, rel) => ({ x: p.x + p.range * Math.cos(p.yaw + rel), y: p.y + p.range * Math.sin(p.yaw + rel) });

/** Change of a cell's log-odds by a ping, `s` and `theta` from the sensor. */
export function evidence(p, s, theta) {
  const [spread, depth] = [sonar.half / 2, 0.03];
  if (p.outcome === 0) {
    if (s > sonar.trustedM) return 0;
    const q = 0.5 - 0.07 * Math.exp(-0.5 * (theta / spread) ** 2);
    return Math.log(q / (1 - q));
  }
  const g = Math.exp(-0.5 * (theta / spread) ** 2) * Math.max(0.25, 1 - p.range / 6);
  let q = 0.5;
  if (Math.abs(s - p.range) <= 2 * depth) q = 0.5 + 0.35 * g * Math.exp(-0.5 * ((s - p.range) / depth) ** 2);
  else if (s > 0.06 && s < p.range - 2 * depth) q = 0.5 - 0.25 * g;
  return Math.log(q / (1 - q));
}

/** Cells of a ping with their changes. */
export function* changes(p, size = cellM) {
  if (p.outcome === 3) return;
  const reach = (p.outcome === 0 ? sonar.trustedM : p.range) + 0.08;
  for (let j = Math.floor((p.y - reach) / size); j <= (p.y + reach) / size; j++) {
    for (let i = Math.floor((p.x - reach) / size); i <= (p.x + reach) / size; i++) {
      const [dx, dy] = [(i + 0.5) * size - p.x, (j + 0.5) * size - p.y];
      const s = Math.hypot(dx, dy);
      const theta = wrap(Math.atan2(dy, dx) - p.yaw);
      if (s > reach || Math.abs(theta) > sonar.half) continue;
      const d = evidence(p, s, theta);
      if (Math.abs(d) > 1e-3) yield { i, j, s, theta, d };
    }
  }
}

function crossings(a, b) {
  const [dx, dy] = [b.x - a.x, b.y - a.y];
  const d = Math.hypot(dx, dy);
  if (d < 1e-9 || d > a.range + b.range || d < Math.abs(a.range - b.range)) return [];
  const q = (d * d + a.range ** 2 - b.range ** 2) / (2 * d);
  const h2 = a.range ** 2 - q * q;
  if (h2 < 1e-12) return [];
  const out = [];
  for (const side of [1, -1]) {
    const h = (side * Math.sqrt(h2)) / d;
    const [x, y] = [a.x + (q * dx) / d - h * dy, a.y + (q * dy) / d + h * dx];
    const [ta, tb] = [Math.atan2(y - a.y, x - a.x), Math.atan2(y - b.y, x - b.x)];
    const [ra, rb] = [wrap(ta - a.yaw), wrap(tb - b.yaw)];
    if (Math.abs(ra) > sonar.half || Math.abs(rb) > sonar.half) continue;
    let angle = Math.abs(wrap(ta - tb));
    if (angle > Math.PI / 2) angle = Math.PI - angle;
    out.push({ x, y, ra, rb, angle });
  }
  return out;
}

function carve(i, j) {
  if (Math.hypot(i.x - j.x, i.y - j.y) >= i.range + j.range) return false;
  let cut = false;
  for (let m = 0; m < samples; m++) {
    if (!i.keep[m]) continue;
    const at = onArc(i, sonar.half * ((2 * m) / (samples - 1) - 1));
    const [dx, dy] = [at.x - j.x, at.y - j.y];
    if (Math.hypot(dx, dy) < j.range - guard && Math.abs(wrap(Math.atan2(dy, dx) - j.yaw)) < sonar.half) {
      i.keep[m] = 0;
      cut = true;
    }
  }
  return cut;
}

/** Slots of a method, and which of them changed since when. */
class Points {
  records = [];
  changed = new Map();
  sequence = 0;

  put(slot, record) {
    this.records[slot] = record;
    this.changed.set(slot, ++this.sequence);
  }

  since(sequence) { return [...this.changed].filter(([, s]) => s > sequence).map(([slot]) => slot); }
}

export class Maps {
  pings = [];
  points = { atm: new Points(), carve: new Points(), centerline: new Points() };
  cells = new Map(); // "column,row" -> { column, row, odds: Float32Array, sequence }
  sequence = 0;
  #recent = [];

  add(p) {
    p.id = this.pings.length;
    this.pings.push(p);
    this.sequence++;
    for (const { i, j, d } of changes(p)) this.#cell(i, j, d);
    if (p.outcome !== 1) return;
    Object.assign(p, { keep: new Uint8Array(samples).fill(1), crossed: [], flat: 0, cutters: [] });
    const touched = new Set([p]);
    for (const q of this.#recent) {
      for (const c of crossings(p, q)) {
        if (c.angle < leastCrossing) { p.flat++; q.flat++; continue; }
        p.crossed.push({ ping: q, rel: c.ra, angle: c.angle, x: c.x, y: c.y });
        q.crossed.push({ ping: p, rel: c.rb, angle: c.angle, x: c.x, y: c.y });
        touched.add(q);
      }
      if (carve(q, p)) { q.cutters.push(p); touched.add(q); }
    }
    this.#recent.push(p);
    if (this.#recent.length > remembered) this.#recent.shift();
    for (const q of touched) this.#place(q);
  }

  #cell(i, j, d) {
    const [column, row] = [Math.floor(i / 64), Math.floor(j / 64)];
    const key = `${column},${row}`;
    const tile = this.cells.get(key) ?? { column, row, odds: new Float32Array(4096), sequence: 0 };
    const at = (j - 64 * row) * 64 + i - 64 * column;
    tile.odds[at] = Math.max(-8, Math.min(8, tile.odds[at] + d));
    tile.sequence = this.sequence;
    this.cells.set(key, tile);
  }

  #place(p) {
    const put = (method, rel, bound, support) => this.points[method].put(p.id, { ...onArc(p, rel), p, rel, bound, support });
    put('centerline', 0, 2 * p.range * Math.sin(sonar.half / 2), 1);
    if (p.crossed.length >= 2) {
      const rels = p.crossed.map((c) => c.rel).sort((a, b) => a - b);
      const m = rels.length >> 1;
      put('atm', rels.length & 1 ? rels[m] : (rels[m - 1] + rels[m]) / 2, Math.min(sonar.quantum / Math.tan(leastCrossing / 2) / 2, p.range * sonar.half), rels.length);
    }
    if (p.cutters.length === 0) return;
    const text = p.keep.join('');
    const pieces = text.match(/1+/g) ?? [];
    if (pieces.length !== 1) { this.points.carve.put(p.id, null); return; }
    const [low, high] = [text.indexOf('1'), text.lastIndexOf('1')].map((k) => sonar.half * ((2 * k) / (samples - 1) - 1));
    put('carve', (low + high) / 2, 2 * p.range * Math.sin((high - low) / 4), p.cutters.length);
  }

  /** Mean and worst 5 % of the errors of a method, in metres. */
  score(method) {
    const errors = [];
    if (method === 'evidence') {
      for (const { column, row, odds } of this.cells.values())
        for (let k = 0; k < 4096; k += 3) if (odds[k] > 1) errors.push(wallDistance((64 * column + (k % 64) + 0.5) * cellM, (64 * row + (k >> 6) + 0.5) * cellM));
    } else {
      for (const r of this.points[method].records) if (r) errors.push((r.error ??= wallDistance(r.x, r.y)));
    }
    errors.sort((a, b) => a - b);
    const mean = errors.reduce((sum, e) => sum + e, 0) / errors.length;
    return errors.length ? { points: errors.length, mae: mean, p95: errors[Math.floor(0.95 * errors.length)] } : { points: 0, mae: null, p95: null };
  }
}
