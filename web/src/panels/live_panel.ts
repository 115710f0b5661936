// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

import type { LayerName } from '../model/model.ts';
import type { App, Panel } from '../ui/app.ts';
import { h } from '../ui/dom.ts';
import { fixed, words } from '../ui/format.ts';
import { layerPicture } from '../ui/marks.ts';
import { planInWords } from '../ui/plan_words.ts';
import { methodRows } from './method_rows.ts';
import { readings, showRejected } from './readings.ts';
import { refill } from './refill.ts';
import { wireCrosshair } from './crosshair.ts';
import { scoreSection } from './score_chart.ts';

const layers: readonly [LayerName, string][] = [['arcs', 'Arcs and cones'], ['bounds', 'Error bounds'], ['path', 'Path'], ['plan', 'Plan'], ['truth', 'True walls'], ['laser', 'Laser']];
const arcWords: Record<string, string> = { scan: 'last scan', 250: 'last 250' };

function arcsFact({ model }: App): string {
  const { arcs } = model.view;
  if (arcs.startsWith('r')) return words(model.welcome?.rejections[Number(arcs.slice(1))]?.name ?? 'rejected');
  return arcWords[arcs] ?? `sensor ${arcs.slice(1)}`;
}

function layerFact(app: App, name: LayerName): { fact: string; off: boolean } {
  const source = app.model.welcome?.source;
  if (name === 'arcs') return { fact: arcsFact(app), off: false };
  if (name === 'bounds') return { fact: 'on points', off: false };
  if (name === 'path') return { fact: `${fixed(app.model.state?.distance_m ?? 0, 1)} m`, off: false };
  if (name === 'plan') return { fact: planInWords(app.model.plan), off: false };
  const there = name === 'truth' ? (source?.walls.length ?? 0) > 0 : source?.has_laser ?? false;
  return { fact: there ? '' : 'not in this source', off: !there };
}

export function layerRows(app: App): HTMLElement[] {
  return layers.map(([name, title]) => {
    const { fact, off } = layerFact(app, name);
    const box = h('input', { type: 'checkbox', class: 'ck', 'aria-label': title, disabled: off });
    box.checked = app.model.view.layers.has(name) && !off;
    box.addEventListener('change', () => {
      const next = new Set(app.model.view.layers);
      if (box.checked) next.add(name); else next.delete(name);
      app.model.show({ layers: next });
    });
    const factNode = name === 'arcs'
      ? h('button', { class: 'm link', title: 'Which arcs' }, fact, { click: () => app.model.show({ arcs: app.model.view.arcs === 'scan' ? '250' : 'scan' }) })
      : h('span', { class: 'm' }, fact);
    return h('div', { class: `lrow${off ? ' off' : ''}` }, [box, layerPicture(name), h('span', {}, title), factNode]);
  });
}

export function makeLivePanel(app: App): Panel {
  const rows = h('div'), chart = h('div', { class: 'charted' }), layerBox = h('div'), readBox = h('section', { class: 'sec' });
  const against = h('span', { class: 'r' });
  let opened: string | null = null;
  const update = (): void => {
    against.textContent = app.model.scores?.reason ? 'points' : 'mean error';
    refill(rows, methodRows(app));
    refill(chart, scoreSection(app));
    refill(layerBox, layerRows(app));
    refill(readBox, readings(app, opened, (name) => { opened = name; showRejected(app, name); update(); }));
  };
  return {
    title: 'Methods and layers', update, unmount: () => undefined,
    mount(host) {
      wireCrosshair(app, chart);
      host.append(
        h('section', { class: 'sec' }, [h('h2', {}, ['Methods', against]), rows]), h('section', { class: 'sec' }, [h('h2', {}, 'Mean error, cm'), chart]),
        h('section', { class: 'sec', id: 'layers', tabindex: -1 }, [h('h2', {}, 'Layers'), layerBox]), readBox);
      update();
    },
  };
}
