// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** What the parts of the page share. */
import type { MapView } from '../map/map_view.ts';
import { runningOf } from '../model/instances.ts';
import type { PageModel } from '../model/page_model.ts';
import type { Driving } from '../drive/driving.ts';
import type { ViewName } from '../model/model.ts';

export interface App {
  readonly model: PageModel;
  readonly map: MapView;
  readonly driving: Driving;
  /** Name of a method as people read it. */
  titleOf(method: string): string;
  shortOf(method: string): string;
  mapHost: HTMLElement;
}

/** A content of the inspector. `update` comes at most ten times a second while it is shown. */
export interface Panel {
  readonly title: string;
  mount(host: HTMLElement): void;
  update(): void;
  unmount(): void;
}

const makers = new Map<ViewName, (app: App) => Panel>();

/** The inspector shows this panel while the view has that name. */
export function registerPanel(view: ViewName, make: (app: App) => Panel): void { makers.set(view, make); }
export function panelFor(view: ViewName, app: App): Panel | null {
  const make = makers.get(view) ?? makers.get('map');
  return make ? make(app) : null;
}

/** The short name: rows are narrow; the full title stands in the options. */
export function methodTitle(model: PageModel, method: string): string {
  return methodShort(model, method);
}
export function methodShort(model: PageModel, method: string): string {
  const running = runningOf(model.methods, method);
  if (running) return running.label;
  const found = model.welcome?.catalogue.find((m) => m.name === method);
  return found?.short || found?.title || method;
}
