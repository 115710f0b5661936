// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** The inspector shows the panel of the view; on narrow pages it is a sheet. */
import { panelFor, type App, type Panel } from './app.ts';
import { h } from './dom.ts';
import { icon, type IconName } from './icons.ts';

const intervalMs = 400;

export function mountInspector(app: App, host: HTMLElement): void {
  let panel: Panel | null = null;
  let shown = '';
  let due = false;
  const body = h('div', { class: 'panel' });
  const handle = h('button', { class: 'handle', 'aria-label': 'Size of this sheet' });
  host.append(handle, body);
  wireHandle(host, handle);
  wireRail(host);
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
    if (!first && name !== 'map') document.body.toggleAttribute('data-sheet', name !== 'compare' || isOpen());
    if (!first) body.querySelector<HTMLElement>('h1[tabindex]')?.focus({ preventScroll: true });
  };
  const soon = (): void => {
    if (due) return;
    due = true;
    setTimeout(() => { due = false; if (!document.hidden) panel?.update(); }, intervalMs);
  };
  app.model.on('welcome', open);
  app.model.on('view', () => { open(); panel?.update(); });
  for (const topic of ['scores', 'counters', 'recompute', 'state'] as const) app.model.on(topic, soon);
  app.model.on('methods', () => panel?.update());
  open();
}

const isOpen = (): boolean => document.body.hasAttribute('data-sheet');
const rails = matchMedia('(min-width: 721px) and (max-width: 1023px)');
const parts: readonly [IconName, string, string][] = [['eye', 'Methods', 'h2'], ['layers', 'Layers', '#layers'], ['chart', 'Readings', '.sec:last-child']];

/** Between phones and desks the inspector is a rail of icons; it opens over the map, keeps the focus inside, and Esc closes it. */
function wireRail(host: HTMLElement): void {
  const show = (open: boolean): void => { document.body.toggleAttribute('data-sheet', open); };
  const rail = h('div', { class: 'rail' }, parts.map(([name, label, place]) => h('button', { class: 'ib', 'aria-label': label, title: label }, [icon(name)], {
    click: () => { show(true); host.querySelector(`.panel ${place}`)?.scrollIntoView({ block: 'start' }); focusables(host)[0]?.focus({ preventScroll: true }); },
  })));
  const close = h('button', { class: 'mini sheet-close', 'aria-label': 'Close' }, [icon('cross')], { click: () => { show(false); rail.querySelector('button')?.focus(); } });
  host.prepend(rail, close);
  host.addEventListener('keydown', (event) => {
    if (!rails.matches || !isOpen()) return;
    if (event.key === 'Escape') { show(false); rail.querySelector('button')?.focus(); event.stopPropagation(); return; }
    const all = focusables(host);
    const out = event.shiftKey ? all[0] : all.at(-1);
    if (event.key !== 'Tab' || document.activeElement !== out) return;
    event.preventDefault();
    (event.shiftKey ? all.at(-1) : all[0])?.focus();
  });
}

const focusables = (host: HTMLElement): HTMLElement[] => [...host.querySelectorAll<HTMLElement>('button, input, select, a[href], [tabindex="0"]')].filter((e) => e.offsetParent !== null && !e.matches(':disabled'));

/** A sheet has three stops; the handle steps through them, or is dragged to the nearest. */
function wireHandle(host: HTMLElement, handle: HTMLElement): void {
  const stops = (): number[] => [92, 268, innerHeight * 0.8];
  let from: { y: number; height: number } | null = null;
  let at = 1;
  const set = (px: number): void => host.style.setProperty('--sheet', `${Math.round(px)}px`);
  handle.addEventListener('pointerdown', (event) => { handle.setPointerCapture(event.pointerId); from = { y: event.clientY, height: host.offsetHeight }; });
  handle.addEventListener('pointermove', (event) => { if (from) set(Math.max(92, from.height + from.y - event.clientY)); });
  handle.addEventListener('pointerup', (event) => {
    if (!from) return;
    const moved = Math.abs(event.clientY - from.y) > 6;
    const now = from.height + from.y - event.clientY;
    from = null;
    const all = stops();
    at = moved ? all.reduce((best, stop, i) => (Math.abs(stop - now) < Math.abs((all[best] ?? 0) - now) ? i : best), 0) : (at + 1) % all.length;
    set(all[at] ?? 268);
  });
}
