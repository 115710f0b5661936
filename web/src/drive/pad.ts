// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** The drive pad and the speed box above the map; a gamepad, where one is plugged in. */
import { h, say } from '../ui/dom.ts';
import { fixed } from '../ui/format.ts';
import type { App } from '../ui/app.ts';
import { padToVelocity, stickToVelocity } from './velocity.ts';

const reachPx = 50;

export function mountPad(app: App, over: HTMLElement): { update(): void; togglePad(): void } {
  const knob = h('div', { class: 'knob' });
  const pad = h('div', {
    class: 'pad', role: 'application', tabindex: 0, hidden: true,
    'aria-label': 'Drive pad. Arrow keys or W A S D drive while held; letting go stops.',
  }, [knob]);
  const speed = h('b'), limit = h('b'), free = h('b'), limitWord = h('small', {}, 'limit here');
  const hud = h('div', { class: 'hud', hidden: true }, [
    h('div', {}, [speed, h('small', {}, 'm/s')]), h('div', {}, [limit, limitWord]), h('div', {}, [free, h('small', {}, 'free ahead')]),
  ]);
  over.append(hud, pad);
  wirePad(app, pad, knob);
  let wished = false;
  const update = (): void => {
    const { active } = app.driving;
    document.body.toggleAttribute('data-driving', active);
    hud.hidden = !active;
    pad.hidden = !active || !(wished || matchMedia('(pointer: coarse)').matches);
    const state = app.model.state;
    if (!active || !state) { app.map.setMotion(null); return; }
    app.map.setMotion(app.driving.wanted);
    pollGamepad(app);
    const slowed = state.limited_by !== 'none';
    say(speed, fixed(Math.abs(state.v), 2));
    say(limit, fixed(state.limit_m_s, 2));
    say(limitWord, slowed ? 'slowed' : 'limit here');
    limit.classList.toggle('warned', slowed);
    say(free, state.free_ahead_m === null ? '–' : `${fixed(state.free_ahead_m, 1)} m`);
  };
  return { update, togglePad: () => { wished = !wished; update(); } };
}

function wirePad(app: App, pad: HTMLElement, knob: HTMLElement): void {
  const move = (event: PointerEvent): void => {
    const box = pad.getBoundingClientRect();
    const dx = event.clientX - box.left - box.width / 2;
    const dy = event.clientY - box.top - box.height / 2;
    const shrink = Math.min(1, reachPx / Math.max(1, Math.hypot(dx, dy)));
    knob.style.setProperty('transform', `translate(${dx * shrink}px, ${dy * shrink}px)`);
    const limits = app.model.welcome?.limits;
    if (limits) app.driving.setPad(padToVelocity(dx * shrink, dy * shrink, reachPx, limits.speed_m_s, limits.turn_rate));
  };
  const end = (): void => {
    knob.style.removeProperty('transform');
    app.driving.setPad(null);
  };
  pad.addEventListener('pointerdown', (event) => { pad.setPointerCapture(event.pointerId); move(event); });
  pad.addEventListener('pointermove', (event) => { if (pad.hasPointerCapture(event.pointerId)) move(event); });
  for (const name of ['pointerup', 'pointercancel', 'lostpointercapture'] as const) pad.addEventListener(name, end);
}

function pollGamepad(app: App): void {
  const limits = app.model.welcome?.limits;
  const device = navigator.getGamepads().find((g) => g !== null);
  if (!device || !limits) return;
  if (device.buttons[1]?.pressed) app.driving.stop();
  app.driving.setGamepad(stickToVelocity(device.axes[0] ?? 0, device.axes[1] ?? 0, limits.speed_m_s, limits.turn_rate));
}
