// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Stop never moves, needs no token, asks nothing, and is never queued. */
import { h, say } from '../ui/dom.ts';
import { stopIcon } from '../ui/icons.ts';
import type { App } from '../ui/app.ts';
import { words } from '../words.ts';

const shownMs = 3000;
const standsBelow = 0.02;

export function mountStop(app: App, button: HTMLElement): void {
  const label = h('span', {}, words.stop);
  const second = h('kbd', {}, words.space);
  button.setAttribute('aria-label', 'Stop robot. Shortcut: Space');
  button.append(stopIcon(), label, second);
  let told = '';
  let before = '';
  let until = 0;
  const update = (): void => {
    const { connection, state, me } = app.model;
    const now = performance.now();
    const by = state?.stopped_by ?? null;
    const key = by ? `${by.who}/${by.viewer}` : '';
    if (by && key !== before) {
      told = by.who === 'viewer' ? (by.viewer === me ? words.byYou : `by ${by.name}`) : by.who === 'dead_man' ? 'driver is gone' : by.who;
      until = now + shownMs;
    }
    before = key;
    // Who drives keeps sending, which ends the stop for the server; the person still is to see that it came.
    if (state && Math.abs(state.v) < standsBelow && now - app.driving.stopSentMs < shownMs && now > until) { told = words.byYou; until = app.driving.stopSentMs + shownMs; }
    const fresh = now < until;
    const lost = connection.phase === 'lost' || connection.phase === 'ended';
    button.classList.toggle('said', fresh);
    say(label, fresh ? words.stopped : words.stop);
    say(second, lost ? words.cannotReach : fresh ? told : words.space);
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
