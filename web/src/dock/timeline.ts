// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

import type { App } from '../ui/app.ts';
import { h, say } from '../ui/dom.ts';
import { clock, spokenTime } from '../ui/format.ts';
import { icon } from '../ui/icons.ts';
import { menu } from '../ui/popover.ts';
import { words } from '../words.ts';
import { canvasOf, colour } from './canvas.ts';
import { ghost, hold, isLog, seek, stepPing, togglePause } from './playback.ts';

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
  const now = (): number => model.state?.t ?? 0;
  /** Of a log the end is known; the bins begin with its first second. */
  const begin = (): number => Math.max(0, now() - model.timeline.echoes.length * model.timeline.binS);
  const end = (): number => Math.max(now(), isLog(app) ? begin() + (model.welcome?.source.duration_s ?? 0) : 0);
  let wanted: number | null = null;
  const point = (event: PointerEvent): void => {
    const box = canvas.getBoundingClientRect();
    const place = Math.max(0, Math.min(1, (event.clientX - box.left) / box.width));
    const t = begin() + place * (end() - begin());
    if (isLog(app)) wanted = t;
    else hold(app, place > 0.995 ? null : t);
    draw();
  };
  canvas.addEventListener('pointerdown', (event) => { canvas.setPointerCapture(event.pointerId); point(event); });
  // A log is wound once, where the pointer is let go: winding back maps it anew.
  canvas.addEventListener('pointerup', () => { if (wanted !== null) seek(app, wanted); wanted = null; });
  canvas.addEventListener('pointercancel', () => { wanted = null; });
  canvas.addEventListener('pointermove', (event) => { if (canvas.hasPointerCapture(event.pointerId)) point(event); });
  canvas.addEventListener('keydown', (event) => {
    const by = event.key === 'ArrowLeft' ? -1 : event.key === 'ArrowRight' ? 1 : 0;
    if (by === 0) return;
    event.preventDefault();
    seek(app, Math.max(begin(), Math.min(end(), (model.view.heldAt ?? now()) + by * (event.shiftKey ? 10 : 1))));
  });
  const draw = (): void => {
    if (document.hidden) return;
    const held = model.view.heldAt;
    const at = wanted ?? held ?? now();
    say(time, held === null && !isLog(app) ? clock(at) : `${clock(at)} / ${clock(end())}`);
    const lost = model.connection.phase === 'lost' || model.connection.phase === 'ended';
    const text = lost ? words.held : model.connection.phase === 'connecting' ? words.connecting : held !== null ? words.backToLive : isLog(app) ? (model.state?.playing ? words.playing : words.paused) : words.live;
    if (pill.textContent !== text) pill.replaceChildren(...(held === null ? [h('i', { class: 'dot' })] : []), text);
    const paused = held !== null || (isLog(app) && !(model.state?.playing ?? true));
    if (play.dataset['paused'] !== String(paused)) { play.dataset['paused'] = String(paused); play.replaceChildren(icon(paused ? 'play' : 'pause')); play.setAttribute('aria-label', paused ? 'Play' : 'Pause view'); }
    speed.hidden = !isLog(app);
    say(speed, `${model.state?.speed ?? 1}×`);
    canvas.setAttribute('aria-valuemin', '0');
    canvas.setAttribute('aria-valuemax', String(Math.round(end())));
    canvas.setAttribute('aria-valuenow', String(Math.round(at)));
    canvas.setAttribute('aria-valuetext', `${spokenTime(at)} of ${spokenTime(end())}`);
    bars(at - begin(), end() - begin());
  };
  const bars = (at: number, total: number): void => {
    const drawing = canvasOf(canvas, heightPx);
    if (!drawing) return;
    const { context: c, width } = drawing;
    // Bins of what was not played yet are not known: their place stays empty.
    const share = total > 0 ? Math.min(1, (now() - begin()) / total) : 1;
    const count = Math.max(1, Math.floor((width * share) / barPx));
    const echoes = columns(model.timeline.echoes, count), rejected = columns(model.timeline.rejected, count);
    const most = Math.max(1, ...echoes);
    const done = total > 0 ? at / total : 1;
    const accent = colour('--accent'), rest = colour('--none'), red = colour('--rej');
    echoes.forEach((n, i) => {
      const bar = n > 0 ? 2 + (15 * n) / most : 1;
      const played = (i + 0.5) * barPx <= done * width;
      c.globalAlpha = played ? 0.55 : 0.35;
      c.fillStyle = played ? accent : rest;
      c.fillRect(i * barPx, 25 - bar, 3, bar);
      c.globalAlpha = 1;
      if (rejected[i]) { c.fillStyle = red; c.fillRect(i * barPx, 28, 3, 2.5); }
    });
    if (ghost.t !== null && total > 0) { c.fillStyle = colour('--ink3'); c.fillRect(((ghost.t - begin()) / total) * width, 4, 1, 26); }
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
