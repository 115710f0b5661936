// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Stop never moves, needs no token, asks nothing, and is never queued. */
import { h, say } from '../ui/dom.ts';
import { stopIcon } from '../ui/icons.ts';
import type { App } from '../ui/app.ts';
import { words } from '../words.ts';

const shownMs = 3000;

export function mountStop(app: App, button: HTMLElement): void {
  const label = h('span', {}, words.stop);
  const second = h('kbd', {}, words.space);
  button.setAttribute('aria-label', 'Stop robot. Shortcut: Space');
  button.append(stopIcon(), label, second);
  let before = '';
  let until = 0;
  const update = (): void => {
    const lost = app.model.connection.phase === 'lost' || app.model.connection.phase === 'ended';
    const by = app.model.state?.stopped_by ?? null;
    const key = by ? `${by.who}/${by.viewer}` : '';
    if (key !== before && by) until = performance.now() + shownMs;
    before = key;
    const fresh = by !== null && performance.now() < until;
    say(label, fresh ? words.stopped : words.stop);
    if (lost) say(second, words.cannotReach);
    else if (!fresh) say(second, words.space);
    else say(second, by.who === 'viewer' ? (by.viewer === app.model.me ? 'by you' : `by ${by.name}`) : by.who === 'dead_man' ? 'driver is gone' : by.who);
  };
  let pressedAt = 0;
  button.addEventListener('pointerdown', (event) => {
    if (event.button > 0) return;
    pressedAt = performance.now();
    app.driving.stop();
  });
  // The keyboard and screen readers only click.
  button.addEventListener('click', () => { if (performance.now() - pressedAt > 1000) app.driving.stop(); });
  app.model.on('state', update);
  app.model.on('connection', update);
  app.map.setKeepClear([button]);
}
