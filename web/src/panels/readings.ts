// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

import type { App } from '../ui/app.ts';
import { h, svg } from '../ui/dom.ts';
import { capital, share, whole, words as plain } from '../ui/format.ts';
import { outcomeMark } from '../ui/marks.ts';

/** Every reason a reading is not on the map, with its count; none is left out. */
export function rejectionRows(app: App): { name: string; count: number; remedy: string }[] {
  const { counters, welcome } = app.model;
  if (!counters) return [];
  const all = new Map<string, number>();
  for (const group of [counters.rejected, counters.rejected_odometry])
    for (const [name, count] of Object.entries(group)) if (count > 0) all.set(name, (all.get(name) ?? 0) + count);
  if (counters.too_close > 0) all.set('too_close', (all.get('too_close') ?? 0) + counters.too_close);
  return [...all].map(([name, count]) => ({ name, count, remedy: welcome?.rejections.find((r) => r.name === name)?.remedy ?? '' })).sort((a, b) => b.count - a.count);
}

/** Puts the pings that were rejected for that reason on the map; null: the last scan again. */
export function showRejected({ model }: App, name: string | null): void {
  const reason = model.welcome?.rejections.findIndex((r) => r.name === name) ?? -1;
  if (reason < 0) { if (model.view.arcs.startsWith('r')) model.show({ arcs: 'scan' }); return; }
  model.show({ arcs: `r${reason}`, layers: new Set([...model.view.layers, 'arcs']) });
}

export const sum = (counts: Record<string, number>): number => Object.values(counts).reduce((a, b) => a + b, 0);

function bar(parts: readonly [string, number, string][], total: number): SVGElement {
  let x = 0;
  const rects = parts.filter(([, n]) => n > 0).map(([, n, kind]) => {
    const w = Math.max(4, (308 * n) / Math.max(1, total));
    const rect = svg('rect', { x, y: 0.75, width: Math.max(1, w - 2), height: 6.5, rx: 1, class: `bar-${kind}` });
    x += w;
    return rect;
  });
  return svg('svg', { class: 'readbar', viewBox: '0 0 312 8', preserveAspectRatio: 'none', 'aria-hidden': 'true' }, rects);
}

export function readings(app: App, opened: string | null, open: (name: string | null) => void): HTMLElement[] {
  const c = app.model.counters;
  const rate = c?.sensors.reduce((a, s) => a + s.rate_hz, 0) ?? 0;
  const heading = h('h2', {}, ['Readings', h('span', { class: 'r num' }, c ? `${whole(c.pings)} pings · ${whole(rate)} per second` : '')]);
  if (!c) return [heading];
  const rejected = sum(c.rejected) + c.too_close;
  const line = (kind: 'echo' | 'no_echo' | 'rejected', name: string, n: number): HTMLElement[] =>
    [outcomeMark(kind) as unknown as HTMLElement, h('span', {}, name), h('span', {}, whole(n)), h('span', { class: 'p' }, share(n, c.pings))];
  const reasons = rejectionRows(app).flatMap((r) => [
    h('span'), h('button', { class: 'sub', 'aria-expanded': String(opened === r.name) }, capital(plain(r.name)), { click: () => open(opened === r.name ? null : r.name) }),
    h('span', { class: 'p' }, whole(r.count)), h('span'), ...(opened === r.name && r.remedy ? [h('div', { class: 'hint wide' }, r.remedy)] : []),
  ]);
  const waiting = c.waiting > 0 ? [h('span'), h('span', { class: 'sub' }, 'Waiting for a pose'), h('span', { class: 'p' }, whole(c.waiting)), h('span')] : [];
  return [heading, bar([['', c.echoes, 'echo'], ['', c.no_echoes, 'none'], ['', rejected, 'rej']], c.pings) as unknown as HTMLElement,
    h('div', { class: 'kv' }, [...line('echo', 'Echo', c.echoes), ...line('no_echo', 'No echo', c.no_echoes), ...line('rejected', 'Rejected', rejected), ...reasons, ...waiting])];
}
