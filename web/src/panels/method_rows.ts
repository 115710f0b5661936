// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

import type { App } from '../ui/app.ts';
import { markSlots, type MarkSlot } from '../map/slots.ts';
import { h } from '../ui/dom.ts';
import { centimetres, dash, fixed, whole } from '../ui/format.ts';
import { icon } from '../ui/icons.ts';
import { methodMark } from '../ui/marks.ts';
import { menu } from '../ui/popover.ts';
import { askForToken } from '../drive/rights.ts';
import { words } from '../words.ts';
import { freeId, runningOf, type Running } from '../model/instances.ts';

export const slotsOf = (app: App): Map<string, MarkSlot> => markSlots(app.model.methods, app.model.view.shown);
export const markOf = (app: App, method: string): SVGElement => methodMark(slotsOf(app).get(method) ?? 0);

function facts(app: App, running: Running): string {
  if (running.state === 'failed') return running.reason;
  const score = app.model.scores?.methods.find((m) => m.method === running.method);
  if (!running.points) return running.grid ? `cells of ${fixed(running.grid.cell_m * 100, 0)} cm` : '';
  const count = score?.points ?? app.model.maps.get(running.method)?.points ?? 0;
  if (count === 0) return words.noPoints;
  return `${whole(count)} points${score?.bound_m ? ` · ±${centimetres(score.bound_m, score.bound_m < 0.1 ? 1 : 0)}` : ''}`;
}

function row(app: App, running: Running): HTMLElement {
  const { method } = running;
  const { shown } = app.model.view;
  const on = shown.includes(method);
  const title = app.titleOf(method);
  const mae = app.model.scores?.methods.find((m) => m.method === method)?.mae_m ?? null;
  const rest = shown.filter((m) => m !== method);
  return h('div', { class: `mrow${shown[0] === method ? ' on' : ''}`, 'data-key': method }, [
    markOf(app, method),
    h('button', { class: 'mname', 'aria-label': `Make ${title} the primary method`, title }, [h('b', {}, title), h('small', {}, facts(app, running))], {
      click: () => app.model.show({ shown: [method, ...rest] }),
    }),
    h('div', { class: 'val' }, mae === null ? dash : centimetres(mae)),
    h('button', { class: 'mini', 'aria-label': `Options of ${title}` }, [icon(running.state === 'failed' ? 'warn' : 'gear')], {
      click: () => app.model.show({ name: 'options', optionsOf: method }, true),
    }),
    h('button', { class: `mini${on ? ' act' : ''}`, 'aria-pressed': String(on), 'aria-label': `Show ${title} on the map` }, [icon(on ? 'eye' : 'eyeoff')], {
      click: () => app.model.show({ shown: on ? rest : [...shown, method] }),
    }),
  ]);
}

function addMenu(app: App, opener: HTMLElement): void {
  if (!app.model.welcome?.you.may_drive) { askForToken(app); return; }
  const { methods } = app.model;
  const runs = (name: string): boolean => runningOf(methods, name) !== undefined;
  const first = app.model.welcome.catalogue.filter((m) => !runs(m.name));
  const again = app.model.welcome.catalogue.filter((m) => runs(m.name));
  menu(opener, words.addMethod, [...first, ...again].map((m) => ({
    label: m.title, note: runs(m.name) ? words.another : m.source,
    run: () => {
      const id = freeId(methods?.running ?? [], m.name);
      app.model.send({ type: 'method_add', method: id, ...(id === m.name ? {} : { name: m.name }) });
      app.model.show({ shown: [...app.model.view.shown, id] });
    },
  })));
}

export function methodRows(app: App): HTMLElement[] {
  const rows = (app.model.methods?.running ?? []).map((running) => row(app, running));
  const add: HTMLButtonElement = h('button', { class: 'add', 'aria-haspopup': 'menu' }, words.addMethod, { click: () => addMenu(app, add) });
  return [...rows, add];
}
