// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

import type { App } from '../ui/app.ts';
import { h, svg } from '../ui/dom.ts';
import { capital, clock } from '../ui/format.ts';
import { slotColour } from '../map/slots.ts';
import { slotsOf } from './method_rows.ts';

export const width = 312, left = 26, right = 224;
const top = 6;

/** Smallest of a round series that is at least the value. */
export function niceTop(value: number): number {
  return [0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5].find((step) => step >= value) ?? value;
}

const labelLength = 12, tellingLength = 6;

/** A method beside the end of its line: its last words where the whole would not fit, and no more than tell something. */
export function chartLabel(short: string): string {
  const text = short.replace('Occupancy grid', 'Grid');
  if (text.length <= labelLength) return text;
  const words = text.split(' ');
  let label = words.pop() ?? text;
  for (let before = words.pop(); before !== undefined && label.length < tellingLength && before.length + 1 + label.length <= labelLength; before = words.pop()) label = `${before} ${label}`;
  return capital(label).slice(0, labelLength);
}

/** Moves labels down so that each is `gap` below the one before, then up where they would leave the chart. */
export function pushApart(places: readonly number[], gap = 13, lowest = Number.POSITIVE_INFINITY): number[] {
  const order = places.map((_, i) => i).sort((a, b) => (places[a] ?? 0) - (places[b] ?? 0));
  const out = [...places];
  order.forEach((index, k) => {
    const before = k > 0 ? out[order[k - 1] ?? 0] ?? 0 : Number.NEGATIVE_INFINITY;
    out[index] = Math.max(places[index] ?? 0, before + gap);
  });
  let limit = lowest;
  for (const index of [...order].reverse()) {
    out[index] = Math.min(out[index] ?? 0, limit);
    limit = (out[index] ?? 0) - gap;
  }
  return out;
}

export function scoreChart(app: App, height = 116): SVGElement {
  const bottom = height - 20;
  const slots = slotsOf(app);
  const series = [...app.model.scoreHistory].filter(([, s]) => s.t.length > 1 && s.maeM.some(Number.isFinite));
  const lastT = Math.max(1, ...series.map(([, s]) => s.t.at(-1) ?? 0));
  const limit = niceTop(Math.max(0.02, ...series.flatMap(([, s]) => s.maeM.slice(Math.floor(s.maeM.length / 10)).filter(Number.isFinite))));
  const x = (t: number): number => left + ((right - left) * t) / lastT;
  const y = (v: number): number => bottom - ((bottom - top) * Math.min(limit, v)) / limit;
  const text = (content: string, attributes: Record<string, string | number>): SVGElement => svg('text', { fill: 'var(--ink3)', ...attributes }, [content]);
  const parts: SVGElement[] = [];
  for (const v of [0, limit / 2, limit]) {
    parts.push(svg('path', { d: `M${left} ${y(v) + 0.5}H${right}`, stroke: 'var(--line)' }));
    parts.push(text(String(Number((v * 100).toFixed(1))), { x: left - 6, y: y(v) + 4, 'text-anchor': 'end' }));
  }
  for (const t of [0, lastT / 2, lastT]) parts.push(text(clock(t), { x: x(t), y: height - 4, 'text-anchor': t === lastT ? 'end' : 'middle' }));
  const colours = series.map(([method]) => { const slot = slots.get(method); return slot ? `var(--${slotColour[slot]})` : 'var(--ink2)'; });
  series.forEach(([method, s], i) => {
    const d = s.t.map((t, k) => ({ t, v: s.maeM[k] ?? Number.NaN })).filter((p) => Number.isFinite(p.v)).map((p, k) => `${k ? 'L' : 'M'}${x(p.t).toFixed(1)} ${y(p.v).toFixed(1)}`).join('');
    parts.push(svg('path', { d, fill: 'none', stroke: colours[i] ?? '', 'stroke-width': method === app.model.view.shown[0] ? 2 : 1.5, 'stroke-dasharray': slots.has(method) ? null : '4 2', 'stroke-linejoin': 'round' }));
  });
  const ends = pushApart(series.map(([, s]) => y(s.maeM.filter(Number.isFinite).at(-1) ?? 0)), 13, bottom);
  series.forEach(([method], i) => parts.push(text(chartLabel(app.shortOf(method)), { x: right + 7, y: (ends[i] ?? 0) + 4, fill: colours[i] ?? '', 'font-weight': 550 })));
  return svg('svg', { class: 'chart', viewBox: `0 0 ${width} ${height}`, role: 'img', 'aria-label': 'Mean distance to the true wall over time, per method' }, parts);
}

/** The chart, or why there is none. */
export function scoreSection(app: App, height?: number): HTMLElement[] {
  const reason = app.model.scores?.reason ?? '';
  if (reason) return [h('p', {}, reason)];
  if (![...app.model.scoreHistory.values()].some((s) => s.t.length > 1)) return [h('p', {}, 'Scores appear with the first points.')];
  return [scoreChart(app, height) as unknown as HTMLElement];
}
