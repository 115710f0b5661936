// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** What floats above the map: controls, scale, hints, and what is wrong. */
import { rejectionRows } from '../panels/readings.ts';
import { driverName } from '../drive/rights.ts';
import { modeNow, whoDrove, words } from '../words.ts';
import type { App } from './app.ts';
import { h, say } from './dom.ts';
import { capital, fixed, heading, whole, words as plain } from './format.ts';
import { icon, type IconName } from './icons.ts';
import { planInWords } from './plan_words.ts';
import { toggleSheet } from './sheet.ts';

const hintKey = 'echoarc.hint';

export function mountMapControls(app: App, over: HTMLElement): void {
  const control = (name: IconName, label: string, run: () => void, extra = ''): HTMLButtonElement => h('button', { 'aria-label': label, title: label, class: extra }, [icon(name)], { click: run });
  const follow = control('follow', 'Follow robot', () => app.model.show({ follow: !app.model.view.follow }));
  const layers = control('layers', 'Layers', toggleSheet, 'lay');
  over.append(h('div', { class: 'mapctl', role: 'group', 'aria-label': 'Map view' }, [
    control('plus', 'Zoom in', () => app.map.zoom(1.25), 'zoom'), control('minus', 'Zoom out', () => app.map.zoom(0.8), 'zoom'), control('fit', 'Fit map', () => app.map.fit()), layers, follow]));
  const bar = h('i'), length = h('span'), place = h('span', { class: 'xy' }), nth = h('span');
  over.append(h('div', { class: 'scale', 'aria-hidden': 'true' }, [h('span', { class: 'sb' }, [bar]), length, nth, place]));
  const box = bar.parentElement;
  const show = (): void => {
    const { scaleBar } = app.map;
    box?.style.setProperty('width', `${scaleBar.lengthPx}px`);
    say(length, scaleBar.label);
    say(nth, app.map.everyNth > 1 ? `1 in ${app.map.everyNth} drawn` : '');
  };
  app.map.onCamera = show;
  app.map.onMove = (x, y) => say(place, `x ${fixed(x, 2)}  y ${fixed(y, 2)} m`);
  app.model.on('view', () => { follow.setAttribute('aria-pressed', String(app.model.view.follow)); });
  show();
}

export function mountHint(app: App, over: HTMLElement): void {
  if (localStorage.getItem(hintKey)) return;
  const hide = (): void => { pill.remove(); localStorage.setItem(hintKey, 'seen'); };
  const pill = h('div', { class: 'hintp' }, [words.hint, h('button', { class: 'mini', 'aria-label': words.hideHint }, [icon('cross')], { click: hide })]);
  over.append(pill);
  app.model.on('view', () => { pill.hidden = app.model.view.name !== 'map'; if (app.model.view.name === 'explain') hide(); });
}

export function mountLost(app: App, over: HTMLElement): void {
  const title = h('span'), text = h('p'), retry = h('button', { class: 'btn pri' }, words.tryNow, { click: () => app.model.retryNow() });
  const box = h('div', { class: 'lost', role: 'alert', hidden: true }, [h('b', {}, [h('span', { class: 'dot' }), title]), text, retry]);
  over.append(box);
  let who = '';
  const update = (): void => {
    const { connection: c, state } = app.model;
    const gone = c.phase === 'lost' || c.phase === 'ended';
    if (!gone && state) who = whoDrove(state.mode, driverName(app), state.driver === app.model.me);
    box.hidden = !gone;
    if (!gone) return;
    const seconds = (performance.now() - c.sinceMs) / 1000;
    const slow = c.reason === 'slow';
    say(title, slow ? 'Disconnected' : seconds > 60 ? words.stillLostTitle : words.lostTitle(seconds));
    say(text, slow ? words.slow : seconds > 60 ? words.stillLost : words.lostBody(state?.t ?? 0, who, (c.retryAtMs - performance.now()) / 1000 || 0));
    say(retry, slow ? words.reconnect : words.tryNow);
  };
  app.model.on('connection', update);
  app.model.on('state', update);
  setInterval(update, 500);
}

/** Why the map is empty: not connected yet, or nothing was heard yet. */
export function mountNotice(app: App, over: HTMLElement): void {
  const box = h('p', { class: 'notice', role: 'status', hidden: true });
  over.append(box);
  const begin = performance.now();
  const update = (): void => {
    const { connection, counters, welcome } = app.model;
    const text = !welcome && connection.phase === 'connecting' ? (performance.now() - begin > 400 ? `${words.connecting} …` : '') : counters?.pings === 0 ? words.noPings : '';
    box.hidden = text === '';
    say(box, text);
  };
  for (const topic of ['connection', 'counters', 'welcome'] as const) app.model.on(topic, update);
  setTimeout(update, 450);
}

/** Pings came, but no map: says where they went. */
export function mountEmpty(app: App, over: HTMLElement): void {
  const box = h('div', { class: 'card', hidden: true });
  over.append(box);
  app.model.on('counters', () => {
    const c = app.model.counters;
    if (!c) return;
    const nothing = c.pings > 50 && c.echoes + c.no_echoes === 0;
    box.hidden = !nothing;
    if (!nothing) return;
    box.replaceChildren(h('h1', {}, words.noneOnMap(c.pings)), h('p', {}, words.noneDroppedSilently),
      h('div', { class: 'kv' }, rejectionRows(app).flatMap((r) => [h('span'), h('span', {}, capital(plain(r.name))), h('span', {}, whole(r.count)), h('span', { class: 'fixr' }, r.remedy)])));
  });
}

/** The map in words, at most every 5 s. */
export function mountLiveText(app: App, host: HTMLElement): void {
  setInterval(() => {
    const s = app.model.state;
    if (!s || document.hidden) return;
    const points = app.model.maps.get(app.model.view.shown[0] ?? '')?.points ?? 0;
    const { plan } = app.model;
    const purpose = plan ? ` ${modeNow(s.mode)}${s.detail === '' ? '' : `, ${s.detail}`}: ${planInWords(plan)}.` : '';
    say(host, `Robot at ${fixed(s.pose[0], 1)}, ${fixed(s.pose[1], 1)} m, heading ${heading(s.pose[2])}, ${fixed(Math.abs(s.v), 2)} m/s. ${whole(points)} points.${purpose}`);
  }, 5000);
}
