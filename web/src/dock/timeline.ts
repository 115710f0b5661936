// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

import type { App } from '../ui/app.ts';
import { h, say } from '../ui/dom.ts';
import { clock, spokenTime } from '../ui/format.ts';
import { icon } from '../ui/icons.ts';
import { menu } from '../ui/popover.ts';
import { words } from '../words.ts';
import { canvasOf, colour } from './canvas.ts';
import { hold, isLog, stepPing, togglePause } from './playback.ts';

const heightPx = 32, barPx = 4, speeds = [0.25, 0.5, 1, 2, 4, 8, 16];

/** Sums bins into `count` columns that span all of `bins`. */
export function columns(bins: readonly number[], count: number): number[] {
  const out = new Array<number>(count).fill(0);
  bins.forEach((n, i) => { const at = Math.min(count - 1, Math.floor((i * count) / bins.length)); out[at] = (out[at] ?? 0) + n; });
  return out;
}

export function mountTimeline(app: App, host: HTMLElement): void {
  const { model } = app;
  const button = (name: 'prev' | 'pause' | 'next', label: string, run: () => void): HTMLButtonElement => h('button', { class: 'ib', 'aria-label': label, title: label }, [icon(name)], { click: run });
  const play = button('pause', 'Pause view', () => togglePause(app));
  const time = h('span', { class: 'tm' });
  const canvas = h('canvas', { role: 'slider', tabindex: 0, 'aria-label': 'Time' });
  const speed: HTMLButtonElement = h('button', { class: 'btn sm quiet num', 'aria-label': 'Speed', 'aria-haspopup': 'menu' }, '1×', { click: () => menu(speed, 'Speed', speeds.map((s) => ({ label: `${s}×`, run: () => { model.send({ type: 'playback', speed: s }); } }))) });
  const pill = h('button', { class: 'livep' }, '', { click: () => hold(app, null) });
  host.append(button('prev', 'Previous ping', () => stepPing(app, -1)), play, button('next', 'Next ping', () => stepPing(app, 1)), time, canvas, speed, pill);
  const begin = (): number => end() - model.timeline.echoes.length * model.timeline.binS;
  const end = (): number => model.state?.t ?? 0;
  const seek = (event: PointerEvent): void => {
    const box = canvas.getBoundingClientRect();
    const place = Math.max(0, Math.min(1, (event.clientX - box.left) / box.width));
    const from = Math.max(0, begin());
    hold(app, place > 0.995 ? null : from + place * (end() - from));
  };
  canvas.addEventListener('pointerdown', (event) => { canvas.setPointerCapture(event.pointerId); seek(event); });
  canvas.addEventListener('pointermove', (event) => { if (canvas.hasPointerCapture(event.pointerId)) seek(event); });
  canvas.addEventListener('keydown', (event) => {
    const by = event.key === 'ArrowLeft' ? -1 : event.key === 'ArrowRight' ? 1 : 0;
    if (by === 0) return;
    event.preventDefault();
    hold(app, Math.max(0, Math.min(end(), (model.view.heldAt ?? end()) + by * (event.shiftKey ? 10 : 1))));
  });
  const draw = (): void => {
    if (document.hidden) return;
    const held = model.view.heldAt;
    const now = held ?? end();
    say(time, held === null ? clock(now) : `${clock(now)} / ${clock(end())}`);
    const lost = model.connection.phase === 'lost' || model.connection.phase === 'ended';
    const text = lost ? words.held : held === null ? words.live : words.backToLive;
    if (pill.textContent !== text) pill.replaceChildren(...(held === null ? [h('i', { class: 'dot' })] : []), text);
    const paused = held !== null || (isLog(app) && !(model.state?.playing ?? true));
    if (play.dataset['paused'] !== String(paused)) { play.dataset['paused'] = String(paused); play.replaceChildren(icon(paused ? 'play' : 'pause')); play.setAttribute('aria-label', paused ? 'Play' : 'Pause view'); }
    speed.hidden = !isLog(app);
    say(speed, `${model.state?.speed ?? 1}×`);
    canvas.setAttribute('aria-valuemin', '0');
    canvas.setAttribute('aria-valuemax', String(Math.round(end())));
    canvas.setAttribute('aria-valuenow', String(Math.round(now)));
    canvas.setAttribute('aria-valuetext', `${spokenTime(now)} of ${spokenTime(end())}`);
    bars(now - Math.max(0, begin()), end() - Math.max(0, begin()));
  };
  const bars = (now: number, total: number): void => {
    const drawing = canvasOf(canvas, heightPx);
    if (!drawing) return;
    const { context: c, width } = drawing;
    const count = Math.max(1, Math.floor(width / barPx));
    const echoes = columns(model.timeline.echoes, count), rejected = columns(model.timeline.rejected, count);
    const most = Math.max(1, ...echoes);
    const done = total > 0 ? now / total : 1;
    const accent = colour('--accent'), rest = colour('--none'), red = colour('--rej');
    echoes.forEach((n, i) => {
      const bar = n > 0 ? 2 + (15 * n) / most : 1;
      const played = (i + 0.5) / count <= done;
      c.globalAlpha = played ? 0.55 : 0.35;
      c.fillStyle = played ? accent : rest;
      c.fillRect(i * barPx, 25 - bar, 3, bar);
      c.globalAlpha = 1;
      if (rejected[i]) { c.fillStyle = red; c.fillRect(i * barPx, 28, 3, 2.5); }
    });
    const x = Math.max(4, Math.min(width - 4, done * width));
    c.fillStyle = colour('--ink');
    c.fillRect(x - 1, 2, 2, 28);
    c.beginPath();
    c.arc(x, 5, 4, 0, 7);
    c.fill();
  };
  for (const topic of ['view', 'timeline', 'welcome', 'connection'] as const) model.on(topic, draw);
  setInterval(draw, 1000);
}
