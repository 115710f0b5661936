// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

import type { Methods } from '../protocol/messages.ts';
import type { View } from './model.ts';
import { defaultCompare } from './url_state.ts';

export function defaultView(dark: boolean): View {
  return {
    name: 'map', camera: null, follow: false, shown: [], layers: new Set(['arcs', 'bounds', 'path', 'plan']), arcs: 'scan',
    compare: defaultCompare, heldAt: null, ping: null, step: 1, cell: null, explain: null, sensor: null, optionsOf: null,
    theme: dark ? 'dark' : 'light',
  };
}

const favourites = ['consensus', 'atm_mod'];

/** What is shown unless the person chose: the best method of points over the first grid. */
export function defaultShown(methods: Methods): string[] {
  const points = methods.running.filter((r) => r.points);
  const grids = methods.running.filter((r) => r.grid !== null && !r.points).map((r) => r.method);
  const first = favourites.map((name) => points.find((r) => r.name === name)).find((r) => r !== undefined) ?? points[0];
  return [...(first === undefined ? [] : [first.method]), ...grids.slice(0, 1)];
}
