// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** A line under the pointer on the score chart with the values there; the timeline shows the same moment as a ghost. */
import { ghost } from '../dock/playback.ts';
import type { App } from '../ui/app.ts';
import { h } from '../ui/dom.ts';
import { centimetres, clock } from '../ui/format.ts';
import { chartLabel, left, right, width } from './score_chart.ts';

export function wireCrosshair(app: App, host: HTMLElement): void {
  const line = h('i', { class: 'crossline' }), tag = h('div', { class: 'crosstag' });
  const leave = (): void => { line.remove(); tag.remove(); ghost.t = null; app.model.tell('timeline'); };
  host.addEventListener('pointerleave', leave);
  host.addEventListener('pointermove', (event) => {
    const chart = host.querySelector('svg');
    if (!chart) return;
    const box = chart.getBoundingClientRect();
    const place = (((event.clientX - box.left) / box.width) * width - left) / (right - left);
    if (place < 0 || place > 1) { leave(); return; }
    const lastT = Math.max(1, ...[...app.model.scoreHistory.values()].map((s) => s.t.at(-1) ?? 0));
    const t = place * lastT;
    const values = [...app.model.scoreHistory].flatMap(([method, s]) => {
      const at = s.t.findLastIndex((time) => time <= t);
      return at < 0 ? [] : [h('span', {}, `${chartLabel(app.shortOf(method))} ${centimetres(s.maeM[at] ?? null)}`)];
    });
    ghost.t = t;
    app.model.tell('timeline');
    line.style.setProperty('left', `${event.clientX - box.left}px`);
    tag.style.setProperty(place > 0.5 ? 'right' : 'left', `${place > 0.5 ? box.right - event.clientX + 8 : event.clientX - box.left + 8}px`);
    tag.style.removeProperty(place > 0.5 ? 'left' : 'right');
    tag.replaceChildren(h('b', {}, clock(t)), ...values);
    host.parentElement?.append(line, tag);
    const from = host.offsetTop;
    for (const part of [line, tag]) part.style.setProperty('top', `${from}px`);
  });
}
