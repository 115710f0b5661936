// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** The inspector shows the panel of the view; on narrow pages it is a sheet. */
import { panelFor, type App, type Panel } from './app.ts';
import { h } from './dom.ts';
import { icon, type IconName } from './icons.ts';
import { backButton } from '../panels/back.ts';
import { words } from '../words.ts';
import { closeSheet, coveredPx, onSheet, openSheet, sheetIsOpen, wireHandle } from './sheet.ts';

const intervalMs = 400;

export function mountInspector(app: App, host: HTMLElement): void {
  let panel: Panel | null = null;
  let shown = '';
  let due = false;
  const body = h('div', { class: 'panel' });
  const handle = h('button', { class: 'handle', 'aria-label': 'Size of this sheet' });
  const rail = h('div', { class: 'rail' }), head = h('div', { class: 'sheet-head' });
  host.append(rail, head, handle, body);
  wireHandle(host, handle);
  wireHead(app, head, rail);
  wireRail(host, rail);
  const open = (): void => {
    const { name } = app.model.view;
    if (name === shown || !app.model.welcome) return;
    const first = shown === '';
    panel?.unmount();
    body.replaceChildren();
    shown = name;
    panel = panelFor(name, app);
    panel?.mount(body);
    host.scrollTop = 0;
    if (name !== 'map' && name !== 'compare') openSheet();
    if (!first) body.querySelector<HTMLElement>('h1[tabindex]')?.focus({ preventScroll: true });
  };
  const soon = (): void => {
    if (due) return;
    due = true;
    setTimeout(() => { due = false; if (!document.hidden) panel?.update(); }, intervalMs);
  };
  const cover = (): void => app.map.setCovered(coveredPx());
  onSheet(cover);
  addEventListener('resize', cover);
  app.model.on('welcome', open);
  app.model.on('view', () => { open(); panel?.update(); });
  for (const topic of ['scores', 'counters', 'recompute', 'state'] as const) app.model.on(topic, soon);
  app.model.on('methods', () => panel?.update());
  open();
}

const rails = matchMedia('(min-width: 721px) and (max-width: 1023px)');
const parts: readonly [IconName, string, string][] = [['eye', 'Methods', 'h2'], ['layers', 'Layers', '#layers'], ['chart', 'Readings', '.sec:last-child']];

/** First line of a sheet from the right: where it leads back to, and what closes it; it stays while the rest scrolls. */
function wireHead(app: App, head: HTMLElement, rail: HTMLElement): void {
  const close = h('button', { class: 'mini sheet-close', 'aria-label': 'Close' }, [icon('cross')], { click: () => { closeSheet(); rail.querySelector('button')?.focus(); } });
  const title = h('b', {}, words.back);
  const back = backButton(app);
  head.append(title, back, close);
  const update = (): void => {
    const onMap = app.model.view.name === 'map';
    title.hidden = !onMap;
    back.hidden = onMap;
  };
  app.model.on('view', update);
  update();
}

/** Between phones and desks the inspector is a rail of icons; it opens over the map, keeps the focus inside, and Esc closes it. */
function wireRail(host: HTMLElement, rail: HTMLElement): void {
  rail.append(...parts.map(([name, label, place]) => h('button', { class: 'ib', 'aria-label': label, title: label }, [icon(name)], {
    click: () => { openSheet(); host.querySelector(`.panel ${place}`)?.scrollIntoView({ block: 'start' }); focusables(host)[0]?.focus({ preventScroll: true }); },
  })));
  host.addEventListener('keydown', (event) => {
    if (!rails.matches || !sheetIsOpen()) return;
    if (event.key === 'Escape') { closeSheet(); rail.querySelector('button')?.focus(); event.stopPropagation(); return; }
    const all = focusables(host);
    const out = event.shiftKey ? all[0] : all.at(-1);
    if (event.key !== 'Tab' || document.activeElement !== out) return;
    event.preventDefault();
    (event.shiftKey ? all.at(-1) : all[0])?.focus();
  });
}

const focusables = (host: HTMLElement): HTMLElement[] => [...host.querySelectorAll<HTMLElement>('button, input, select, a[href], [tabindex="0"]')].filter((e) => e.offsetParent !== null && !e.matches(':disabled'));
