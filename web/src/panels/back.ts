// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

import type { App } from '../ui/app.ts';
import { h } from '../ui/dom.ts';
import { icon } from '../ui/icons.ts';
import { words } from '../words.ts';

export function backButton(app: App): HTMLElement {
  return h('button', { class: 'back' }, [icon('back'), words.back, h('kbd', {}, 'Esc')], { click: () => app.model.show({ name: 'map' }, true) });
}
