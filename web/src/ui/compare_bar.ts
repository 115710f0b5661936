// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Switch between side by side, swipe and blend; labels of the panes; the divider. */
import { markOf } from '../panels/method_rows.ts';
import { comparedMethods, isPoints, mostPanes, sideAreas } from '../map/scene_builder.ts';
import { compared } from '../panels/compare_panel.ts';
import { refill } from '../panels/refill.ts';
import type { App } from './app.ts';
import { h, say } from './dom.ts';
import { centimetres } from './format.ts';
import { words } from '../words.ts';

const modes = [['side', 'Side by side'], ['swipe', 'Swipe'], ['blend', 'Blend']] as const;

export function mountCompareBar(app: App, over: HTMLElement): void {
  const { model } = app;
  const set = (change: Partial<typeof model.view.compare>): void => model.show({ compare: { ...model.view.compare, ...change } });
  const buttons = modes.map(([mode, label]) => h('button', { 'aria-pressed': 'false' }, label, { click: () => set({ mode, methods: compared(app) }) }));
  const blend = h('input', { type: 'range', class: 'slide', min: 0, max: 1, step: 0.01, 'aria-label': 'Blend' });
  blend.addEventListener('input', () => set({ blend: Number(blend.value) }));
  const ends = [h('span', { class: 'end' }), h('span', { class: 'end' })] as const;
  const legend = h('div', { class: 'blend-legend' });
  const blending = h('div', { class: 'blending', hidden: true }, [ends[0], blend, ends[1]]);
  const bar = h('div', { class: 'cbar', hidden: true }, [legend, h('div', { class: 'cbar-row' }, [h('div', { class: 'seg' }, buttons), blending])]);
  const labels = h('div'), divider = h('div', { class: 'clsw', hidden: true, role: 'slider', tabindex: 0, 'aria-label': 'Divider', 'aria-valuemin': 0, 'aria-valuemax': 100 });
  over.append(labels, divider, bar);
  const width = (): number => app.mapHost.clientWidth;
  const move = (place: number): void => set({ swipe: Math.max(0.02, Math.min(0.98, place)) });
  divider.addEventListener('pointerdown', (event) => divider.setPointerCapture(event.pointerId));
  divider.addEventListener('pointermove', (event) => { if (divider.hasPointerCapture(event.pointerId)) move((event.clientX - app.mapHost.getBoundingClientRect().left) / width()); });
  divider.addEventListener('keydown', (event) => {
    const by = event.key === 'ArrowLeft' ? -1 : event.key === 'ArrowRight' ? 1 : 0;
    if (by === 0) return;
    event.preventDefault();
    event.stopPropagation();
    move(model.view.compare.swipe + (by * (event.shiftKey ? 10 : 1)) / width());
  });
  const update = (): void => {
    const on = model.view.name === 'compare';
    const { mode, swipe } = model.view.compare;
    if (on && model.view.compare.methods.length === 0 && model.methods) { set({ methods: compared(app) }); return; }
    bar.hidden = !on;
    labels.hidden = !on;
    divider.hidden = !on || mode !== 'swipe';
    blending.hidden = mode !== 'blend';
    if (!on) return;
    const blended = comparedMethods(model).slice(0, 2);
    blended.forEach((method, i) => { const end = ends[i]; if (end) say(end, app.titleOf(method)); });
    refill(legend, mode === 'blend' ? blendLegend(app, blended) : []);
    blend.value = String(model.view.compare.blend);
    buttons.forEach((b, i) => { const here = modes[i]?.[0] === mode; b.classList.toggle('on', here); b.setAttribute('aria-pressed', String(here)); });
    divider.style.setProperty('left', `${swipe * 100}%`);
    divider.setAttribute('aria-valuenow', String(Math.round(swipe * 100)));
    showLabels(app, labels);
  };
  for (const topic of ['view', 'methods', 'scores'] as const) model.on(topic, update);
  addEventListener('resize', () => requestAnimationFrame(update));
}

/** Of two grids the colours say which holds a cell occupied, so these are named; points have their marks. */
function blendLegend(app: App, methods: readonly string[]): HTMLElement[] {
  const [first, second] = methods;
  if (first === undefined || second === undefined || methods.some((m) => isPoints(app.model, m))) return [];
  const entry = (kind: string, text: string): HTMLElement => h('span', {}, [h('i', { class: `key ${kind}` }), text]);
  return [h('span', { class: 'what' }, words.occupiedIn), entry('fuller', words.onlyIn(app.titleOf(first))), entry('occ', words.inBoth), entry('emptier', words.onlyIn(app.titleOf(second)))];
}

function showLabels(app: App, host: HTMLElement): void {
  const { mode, swipe, methods } = app.model.view.compare;
  const error = (m: string): number | null => app.model.scores?.methods.find((s) => s.method === m)?.mae_m ?? null;
  const { clientWidth: width, clientHeight: height } = app.mapHost;
  const own = methods.slice(0, mode === 'side' ? mostPanes(width) : 2);
  const areas = mode === 'side' ? sideAreas(own.length, width, height, mostPanes(width)) : own.map((_, i) => {
    const at = (mode === 'swipe' ? swipe : 0.5) * width;
    return { x: i === 0 ? 0 : at, y: 0, width: i === 0 ? at : width - at, height };
  });
  const places = own.map((method, i) => ({ method, area: areas[i] ?? { x: 0, y: 0, width, height } }));
  const best = places.map((p) => error(p.method) ?? Number.POSITIVE_INFINITY).reduce((a, b) => Math.min(a, b), Number.POSITIVE_INFINITY);
  refill(host, places.map(({ method, area }) => {
    const e = error(method);
    const label = h('div', { class: 'pl' }, [markOf(app, method), h('b', {}, app.titleOf(method)), e !== null && h('small', {}, `${centimetres(e)} error`), e !== null && e === best && h('span', { class: 'best' }, 'closest')]);
    label.style.setProperty('left', `${area.x + 14}px`);
    label.style.setProperty('top', `${area.y + 12}px`);
    label.style.setProperty('max-width', `${Math.max(80, area.width - 28)}px`);
    return label;
  }));
}
