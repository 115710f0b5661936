// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

import type { App } from './app.ts';
import { driveKeys } from '../drive/velocity.ts';
import type { ViewName } from '../model/model.ts';
import { lettersOn, showShortcuts } from './shortcuts.ts';
import { stepPing, togglePause } from '../dock/playback.ts';

export interface KeyActions { togglePad(): void; toggleStrip(): void; startGoTo(): boolean; cancel(): boolean; focusLayers(): void }

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
  const key = event.key.toLowerCase();
  const view = views[key];
  if (view) { model.show({ name: view }, true); return true; }
  const digit = /^Digit([1-9])$/.exec(event.code);
  if (digit) { toggleMethod(app, Number(digit[1]) - 1, event.shiftKey); return true; }
  const simple: Record<string, () => void> = {
    f: () => model.show({ follow: !model.view.follow }), b: actions.toggleStrip, j: actions.togglePad, g: actions.startGoTo, l: actions.focusLayers,
    k: () => togglePause(app), '?': () => showShortcuts(app), ',': () => stepPing(app, event.shiftKey ? -16 : -1), '.': () => stepPing(app, event.shiftKey ? 16 : 1),
    '<': () => stepPing(app, -16), '>': () => stepPing(app, 16),
  };
  const run = simple[key];
  run?.();
  return run !== undefined;
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
