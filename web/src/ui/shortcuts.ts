// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

import type { App } from './app.ts';
import { h } from './dom.ts';
import { dialog } from './popover.ts';

const storageKey = 'echoarc.letters';
export const lettersOn = (): boolean => localStorage.getItem(storageKey) !== 'off';

const rows: readonly [string, string][] = [
  ['Space', 'Stop the robot'], ['W A S D, arrows', 'drive while held; Shift: slowly'], ['+ − 0', 'zoom, fit'], ['F', 'follow robot'],
  ['P, Enter', 'next point; explain it'], ['M C T', 'Map, Compare, Step'], ['1–9', 'show or hide a method; Shift: make it primary'],
  ['L, B, J', 'layers, sensor strip, drive pad'], ['K , .', 'pause the view, previous and next ping'], ['G', 'go to a point'], ['Esc', 'back, cancel'], ['?', 'this list'],
];

export function showShortcuts(app: App): void {
  const box = h('input', { type: 'checkbox', class: 'ck', checked: lettersOn() });
  box.addEventListener('change', () => localStorage.setItem(storageKey, box.checked ? 'on' : 'off'));
  dialog('Shortcuts', [
    h('table', {}, [h('tbody', {}, rows.map(([keys, does]) => h('tr', {}, [h('td', {}, [h('kbd', {}, keys)]), h('td', { class: 'left' }, does)])))]),
    h('label', { class: 'row' }, [box, 'Single letters act']),
  ], () => app.driving.stop());
}
