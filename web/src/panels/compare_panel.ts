// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

import { askForToken } from '../drive/rights.ts';
import { outliersGathering, runningOf, type Gathering } from '../model/instances.ts';
import type { App, Panel } from '../ui/app.ts';
import { h } from '../ui/dom.ts';
import { centimetres, dash, fixed } from '../ui/format.ts';
import { saveBlob } from '../ui/save.ts';
import { wireCrosshair } from './crosshair.ts';
import { layerRows } from './live_panel.ts';
import { markOf } from './method_rows.ts';
import { refill } from './refill.ts';
import { chartLabel, scoreSection } from './score_chart.ts';
import { words } from '../words.ts';

/** Chosen for Compare, or the first four that run. */
export function compared(app: App): string[] {
  const running = (app.model.methods?.running ?? []).map((r) => r.method);
  const chosen = app.model.view.compare.methods.filter((m) => running.includes(m));
  return chosen.length > 0 ? chosen : running.slice(0, 4);
}

function table(app: App, methods: readonly string[]): HTMLElement {
  const head = ['Method', 'Mean', 'Worst 5%', 'Found'].map((name) => h('th', { scope: 'col' }, name));
  const body = methods.map((method) => {
    const s = app.model.scores?.methods.find((m) => m.method === method);
    const found = s?.found ?? null;
    return h('tr', { class: method === app.model.view.shown[0] ? 'own' : '' }, [h('td', { title: app.titleOf(method) }, [h('span', { class: 'named' }, [markOf(app, method), chartLabel(app.shortOf(method))])]),
      h('td', {}, centimetres(s?.mae_m ?? null)), h('td', {}, centimetres(s?.p95_m ?? null, 0)), h('td', {}, found === null ? dash : `${fixed(found * 100, 0)}%`)]);
  });
  return h('table', { class: 'cmp' }, [h('thead', {}, [h('tr', {}, head)]), h('tbody', {}, body)]);
}

function lookOf(app: App, method: string): string {
  const name = runningOf(app.model.methods, method)?.name ?? method;
  return app.model.welcome?.catalogue.find((c) => c.name === name)?.look ?? '';
}

/** Starts what is missing, for which the token is needed, and lays the maps side by side or under the divider. */
export function compareGathered(app: App, { ids, missing }: Gathering, mode: 'side' | 'swipe'): void {
  if (missing.length > 0 && !app.model.welcome?.you.may_drive) { askForToken(app); return; }
  for (const wish of missing) app.model.send(wish);
  app.model.show({ name: 'compare', compare: { ...app.model.view.compare, mode, methods: ids } }, true);
}

function outliersButton(app: App): HTMLElement[] {
  const gathering = outliersGathering(app.model.methods, app.model.welcome?.catalogue ?? []);
  return gathering ? [h('button', { class: 'btn' }, words.outliers, { click: () => {
    const now = outliersGathering(app.model.methods, app.model.welcome?.catalogue ?? []);
    if (now) compareGathered(app, now, 'side');
  } })] : [];
}

function exportTable(app: App): void {
  const lines = ['method,points,mean_m,p95_m,found', ...(app.model.scores?.methods ?? []).map((m) => [m.method, m.points, m.mae_m ?? '', m.p95_m ?? '', m.found ?? ''].join(','))];
  saveBlob(new Blob([`${lines.join('\n')}\n`], { type: 'text/csv' }), 'scores.csv');
}

export function makeComparePanel(app: App): Panel {
  const tableBox = h('div'), chart = h('div', { class: 'charted' }), look = h('div'), layerBox = h('section', { class: 'sec' }), picks = h('div', { class: 'picks' }), presets = h('section', { class: 'sec' });
  const update = (): void => {
    const methods = compared(app);
    refill(tableBox, app.model.scores?.reason ? [h('p', {}, app.model.scores.reason)] : [table(app, methods)]);
    refill(chart, scoreSection(app, 136));
    refill(look, methods.map((m) => h('p', {}, [h('b', {}, `${app.shortOf(m)}: `), lookOf(app, m)])));
    refill(layerBox, layerRows(app));
    const offered = outliersButton(app);
    refill(presets, offered);
    presets.hidden = offered.length === 0;
    refill(picks, (app.model.methods?.running ?? []).map(({ method }) => {
      const on = methods.includes(method);
      const box = h('input', { type: 'checkbox', class: 'ck', checked: on, disabled: !on && methods.length >= 4 });
      box.addEventListener('change', () => {
        const next = box.checked ? [...methods, method] : methods.filter((m) => m !== method);
        if (next.length > 0) app.model.show({ compare: { ...app.model.view.compare, methods: next.slice(0, 4) } });
      });
      return h('label', { class: 'lrow pick' }, [box, markOf(app, method), h('span', {}, app.titleOf(method))]);
    }));
  };
  return {
    title: 'Methods over one log', update, unmount: () => undefined,
    mount(host) {
      wireCrosshair(app, chart);
      host.append(h('section', { class: 'sec' }, [h('h1', { tabindex: -1 }, 'Methods over one log'), h('p', {}, 'All read the same pings. Pan and zoom move all maps together.')]),
        h('section', { class: 'sec' }, [h('h2', {}, 'Against the true walls'), tableBox]), h('section', { class: 'sec' }, [h('h2', {}, 'Mean error, cm'), chart]),
        h('section', { class: 'sec' }, [h('h2', {}, 'What to look for'), look]), h('section', { class: 'sec' }, [h('h2', {}, 'Choose methods'), picks]), presets, layerBox,
        h('div', { class: 'foot' }, [h('button', { class: 'btn grow' }, 'Export table', { click: () => exportTable(app) })]));
      update();
    },
  };
}
