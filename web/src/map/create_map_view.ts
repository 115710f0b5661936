// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

import type { Model } from '../model/model.ts';
import type { MapView, RendererChoice } from './map_view.ts';
import { MapPainter } from './map_painter.ts';

export function createMapView(host: HTMLElement, model: Model, renderer: RendererChoice = 'auto'): MapView {
  return new MapPainter(host, model, renderer);
}
