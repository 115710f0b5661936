// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

import type { App } from './app.ts';
import { driveKeys } from '../drive/velocity.ts';
import type { ViewName } from '../model/model.ts';
import { lettersOn, showShortcuts } from './shortcuts.ts';
import { stepPing, togglePause } from '../dock/playback.ts';

export interface KeyActions { togglePad(): void; toggleStrip(): void; startGoTo(): boolean; cancel(): boolean; walk(direction: 1 | -1): void; explainWalked(): boolean; focusLayers(): void }

const views: Record<string, ViewName> = { m: 'map', c: 'compare', t: 'step' };

function inText(target: EventTarget | null): boolean {
  return target instanceof HTMLElement && (target.matches('input:not([type=checkbox]):not([type=range]), textarea, select') || target.isContentEditable);
}

export function mountKeyboard(app: App, actions: KeyActions): void {
  addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || inText(event.target)) return;
    if (event.key === ' ' && spaceStops(app, event)) { event.preventDefault(); app.driving.stop(); return; }
    if (app.driving.active && event.code in driveKeys) {
      event.preventDefault();
      event.stopImmediatePropagation();
      app.driving.slow = event.shiftKey;
      app.driving.key(event.code, true);
      return;
    }
    if (act(app, actions, event)) event.preventDefault();
  }, true);
  addEventListener('keyup', (event) => { app.driving.slow = event.shiftKey; app.driving.key(event.code, false); });
}

function spaceStops(app: App, event: KeyboardEvent): boolean {
  if (event.repeat) return true;
  const target = event.target as HTMLElement;
  return app.driving.active || target === document.body || app.mapHost.contains(target);
}

function act(app: App, actions: KeyActions, event: KeyboardEvent): boolean {
  const { model } = app;
  if (event.key === 'Escape') return escape(app, actions);
  if (document.querySelector('dialog[open]') || !lettersOn()) return false;
  if (onMap(app, event.target) && mapKey(app, actions, event)) return true;
  const key = event.key.toLowerCase();
  const view = views[key];
  if (view) { model.show({ name: view }, true); return true; }
  const digit = /^Digit([1-9])$/.exec(event.code);
  if (digit) { toggleMethod(app, Number(digit[1]) - 1, event.shiftKey); return true; }
  const simple: Record<string, () => void> = {
    f: () => model.show({ follow: !model.view.follow }), b: actions.toggleStrip, j: actions.togglePad, g: actions.startGoTo, l: actions.focusLayers,
    p: () => actions.walk(event.shiftKey ? -1 : 1), k: () => togglePause(app), '?': () => showShortcuts(app), ',': () => stepPing(app, event.shiftKey ? -16 : -1), '.': () => stepPing(app, event.shiftKey ? 16 : 1),
    '<': () => stepPing(app, -16), '>': () => stepPing(app, 16),
  };
  const run = simple[key];
  run?.();
  return run !== undefined;
}

const onMap = (app: App, target: EventTarget | null): boolean => target === document.body || (target instanceof Node && app.mapHost.contains(target));
const arrows: Record<string, readonly [number, number]> = { ArrowLeft: [1, 0], ArrowRight: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

/** Keys of the map while it, or nothing, has the focus. */
function mapKey({ map }: App, actions: KeyActions, event: KeyboardEvent): boolean {
  const arrow = arrows[event.key];
  const far = event.shiftKey ? 256 : 64;
  if (arrow) map.pan(arrow[0] * far, arrow[1] * far);
  else if (event.key === '+' || event.key === '=') map.zoom(1.25);
  else if (event.key === '-') map.zoom(0.8);
  else if (event.key === '0') map.fit();
  else return event.key === 'Enter' && actions.explainWalked();
  return true;
}

function escape(app: App, actions: KeyActions): boolean {
  if (actions.cancel()) return true;
  if (app.model.view.name === 'map') return false;
  app.model.show({ name: 'map' }, true);
  return true;
}

export function toggleMethod(app: App, index: number, primary: boolean): void {
  const method = app.model.methods?.running[index]?.method;
  if (!method) return;
  const { shown } = app.model.view;
  const rest = shown.filter((m) => m !== method);
  app.model.show({ shown: primary ? [method, ...rest] : shown.includes(method) ? rest : [...shown, method] });
}
