// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** The map alone, for looking at it and measuring it without the page around it. */
import { createMapView, type RendererChoice } from '../../src/map/map_view.ts';
import { createModel } from '../../src/model/page_model.ts';
import type { Explanation, Stepped } from '../../src/protocol/messages.ts';

const model = createModel();
const host = document.querySelector<HTMLElement>('#map');
if (!host) throw new Error('There is no map.');
document.documentElement.dataset['theme'] = model.view.theme;
const map = createMapView(host, model, (new URLSearchParams(location.search).get('renderer') ?? 'auto') as RendererChoice);
const switches = { ray: false, truePose: false };
map.onClick = ({ pick }) => {
  if (pick?.kind === 'point') void explain(pick.method, pick.slot);
};
async function explain(method: string, slot: number, hovered?: number): Promise<void> {
  model.show({ name: 'explain' }, true);
  const e = await model.ask<Explanation>({ type: 'explain', method, slot });
  map.setExplanation(e, hovered === undefined ? null : e.support[hovered]?.ping.ping ?? null);
}
async function step(method: string, ping: number, part: number): Promise<void> {
  model.show({ name: 'step', shown: [method] }, true);
  const s = await model.ask<Stepped>({ type: 'step', method, ping });
  map.setStep(s, part, s.cells[0] ?? null, switches);
}
Object.assign(window, { model, map, explain, step });
model.start();
