// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

import type { App } from './app.ts';
import { askForToken, driverName, wantToDrive } from '../drive/rights.ts';
import { words } from '../words.ts';
import { h, say } from './dom.ts';
import { size } from './format.ts';
import { icon, logo, type IconName } from './icons.ts';
import { openLog } from './open_log.ts';
import { menu, popover } from './popover.ts';
import { saveMenu } from './save.ts';
import { showShortcuts } from './shortcuts.ts';
import { openSheet } from './sheet.ts';
import { toast } from './toast.ts';

function iconButton(name: IconName, label: string, run: (button: HTMLElement) => void): HTMLButtonElement {
  const button = h('button', { class: 'ib', 'aria-label': label, title: label }, [icon(name)], { click: () => run(button) });
  return button;
}

async function openScene(app: App, scene: string): Promise<void> {
  try {
    const { room } = await app.model.ask<{ room: string }>({ type: 'open', scene });
    goToRoom(room, `scene:${scene}`);
  } catch (error) {
    toast(String((error as { message?: string }).message ?? error), [], true);
  }
}

export function goToRoom(room: string, source: string): void {
  location.assign(`${location.pathname}?room=${encodeURIComponent(room)}#src=${encodeURIComponent(source)}`);
}

function sourceMenu(app: App, opener: HTMLElement): void {
  const { welcome } = app.model;
  const scenes = (welcome?.scenes ?? []).map((scene) => ({
    label: scene.title, note: scene.name, current: scene.name === welcome?.source.name,
    run: () => { if (welcome?.you.may_drive) void openScene(app, scene.name); else askForToken(app); },
  }));
  menu(opener, 'Source', [...scenes, { label: 'Open a log…', run: () => openLog(app) }], 'listbox');
}

function connectionPopover(app: App, opener: HTMLElement): void {
  const { connection, welcome, counters } = app.model;
  const row = (name: string, value: string): HTMLElement => h('div', { class: 'pair' }, [h('span', {}, name), h('b', {}, value)]);
  popover(opener, 'Connection', [
    row('Round trip', Number.isFinite(connection.roundTripMs) ? `${Math.round(connection.roundTripMs)} ms` : '–'),
    row('Received', `${size(Math.round(connection.bytesPerS))}/s`),
    row('States dropped for this viewer', String(counters?.dropped ?? 0)),
    row('Log', counters ? `${counters.log.state}, ${size(counters.log.bytes)}` : '–'), row('Server', welcome?.version ?? '–'),
  ]);
}

function watchersPopover(app: App, opener: HTMLElement): void {
  const viewers = app.model.viewers?.viewers ?? [];
  popover(opener, 'Watchers', [
    ...viewers.map((v) => h('div', { class: 'pair' }, [h('span', {}, v.name + (v.viewer === app.model.me ? ' (you)' : '')), h('b', {}, v.driver ? 'drives' : v.asking ? 'asks' : '')])),
    !app.driving.active && h('button', { class: 'btn sm' }, words.askToDrive, { click: () => wantToDrive(app) }),
  ]);
}

export function mountTopBar(app: App, host: HTMLElement): void {
  const { model } = app;
  const name = h('b'), kind = h('span');
  const source: HTMLButtonElement = h('button', { class: 'src', 'aria-haspopup': 'listbox' }, [name, kind, icon('chev')], { click: () => sourceMenu(app, source) });
  const views = (['map', 'compare', 'step'] as const).map((view) => h('a', { href: `#v=${view}` }, view === 'map' ? 'Map' : view === 'compare' ? 'Compare' : 'Step', {
    click: (event) => { event.preventDefault(); model.show({ name: view }, true); if (view === 'step') openSheet(); },
  }));
  const dot = h('i', { class: 'dot' }), phase = h('span'), delay = h('span', { class: 'd' });
  const connection: HTMLButtonElement = h('button', { class: 'conn' }, [dot, phase, delay], { click: () => connectionPopover(app, connection) });
  const count = h('span');
  const watch: HTMLButtonElement = h('button', { class: 'watch' }, [icon('eye'), count], { click: () => watchersPopover(app, watch) });
  const theme = iconButton('moon', 'Dark theme', () => model.show({ theme: model.view.theme === 'dark' ? 'light' : 'dark' }));
  const save: HTMLButtonElement = h('button', { class: 'btn', 'aria-haspopup': 'menu', 'aria-label': words.saveMap }, [icon('save'), h('span', {}, words.saveMap)], { click: () => saveMenu(app, save) });
  const drive = h('button', { class: 'btn pri', 'aria-pressed': 'false' }, [icon('drive'), h('span', { class: 'keep' }, words.drive)], { click: () => wantToDrive(app) });
  const brand = h('a', { class: 'brand', href: '#v=map', 'aria-label': 'echoarc, live map' }, [logo(), h('span', {}, 'echoarc')], {
    click: (event) => { event.preventDefault(); model.show({ name: 'map', heldAt: null }, true); },
  });
  host.append(h('div', { class: 'top-side' }, [brand, source]), h('nav', { class: 'seg modes', 'aria-label': 'View' }, views), h('div', { class: 'top-side right' }, [
    connection, watch, h('span', { class: 'vr' }), iconButton('open', 'Open a log', () => openLog(app)),
    iconButton('link', 'Copy link to this view', () => void navigator.clipboard?.writeText(model.link()).then(() => toast(words.linkCopied))),
    theme, iconButton('help', 'Keyboard shortcuts', () => showShortcuts(app)), save, drive,
  ]));

  const showView = (): void => {
    const dark = model.view.theme === 'dark';
    if (document.documentElement.dataset['theme'] !== model.view.theme) {
      document.documentElement.dataset['theme'] = model.view.theme;
      app.map.retheme();
    }
    document.body.dataset['view'] = model.view.name;
    theme.replaceChildren(icon(dark ? 'sun' : 'moon'));
    theme.setAttribute('aria-label', dark ? 'Light theme' : 'Dark theme');
    const on = model.view.name === 'compare' || model.view.name === 'step' ? model.view.name : 'map';
    views.forEach((link, i) => {
      const here = ['map', 'compare', 'step'][i] === on;
      link.classList.toggle('on', here);
      if (here) link.setAttribute('aria-current', 'page'); else link.removeAttribute('aria-current');
    });
  };
  const showWelcome = (): void => {
    const from = model.welcome?.source;
    if (!from) return;
    const dropped = model.urlOthers.find(([key]) => key === 'src')?.[1] ?? '';
    const title = from.kind === 'log' && dropped.startsWith('log:') ? dropped.slice(4) : from.title;
    document.body.toggleAttribute('data-log', from.kind === 'log');
    say(name, title);
    say(kind, from.kind === 'scene' ? 'simulated' : 'log');
    source.setAttribute('aria-label', `Source: ${title}. Change`);
    document.title = `echoarc · ${title}`;
    drive.hidden = !from.drivable;
  };
  const showConnection = (): void => {
    const { connection: now } = model;
    const live = now.phase === 'live';
    document.body.toggleAttribute('data-connecting', now.phase === 'connecting');
    document.body.toggleAttribute('data-lost', now.phase === 'lost' || now.phase === 'ended');
    say(phase, live ? words.live : now.phase === 'connecting' ? words.connecting : words.reconnecting);
    say(delay, live ? (Number.isFinite(now.roundTripMs) ? `${Math.round(now.roundTripMs)} ms` : '') : now.attempt > 0 ? `try ${now.attempt}` : '');
    drive.disabled = !live;
  };
  const showState = (): void => {
    say(count, String(model.state?.watchers ?? 0));
    watch.setAttribute('aria-label', `${model.state?.watchers ?? 0} watch, ${driverName(app) ?? 'nobody'} drives`);
    drive.setAttribute('aria-pressed', String(app.driving.active));
    drive.classList.toggle('pri', !app.driving.active);
  };
  model.on('view', showView);
  model.on('welcome', showWelcome);
  model.on('connection', showConnection);
  model.on('state', showState);
  showView();
  showConnection();
}
