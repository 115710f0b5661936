// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Time of the view: live, held, stepping through pings; and playing a log. */
import { pingAfter } from '../step/cells.ts';
import type { App } from '../ui/app.ts';

export const isLog = (app: App): boolean => app.model.welcome?.source.kind === 'log';

/** Moment that the pointer is at elsewhere; the timeline marks it. */
export const ghost: { t: number | null } = { t: null };

export function hold(app: App, t: number | null): void { app.model.show({ heldAt: t }); }

/** A log is wound to the time by who may; else the view alone is held there. */
export function seek(app: App, t: number): void {
  if (isLog(app) && app.model.welcome?.you.may_drive) {
    if (app.model.view.heldAt !== null) hold(app, null);
    app.model.send({ type: 'playback', seek_s: t });
  } else hold(app, t);
}

/** Pauses the view, never the robot; of a log it pauses the playing. */
export function togglePause(app: App): void {
  const { model } = app;
  if (model.view.heldAt !== null) hold(app, null);
  else if (isLog(app) && model.welcome?.you.may_drive) model.send({ type: 'playback', playing: !(model.state?.playing ?? false) });
  else hold(app, model.state?.t ?? null);
}

export function stepPing(app: App, by: number): void {
  const { model } = app;
  if (model.view.name === 'step') {
    // Step mode goes through the whole log, and holds the time of its ping itself.
    const ping = pingAfter(model.view.ping ?? model.pings.newest?.id ?? 0, by, model.state?.pings ?? 0);
    if (ping !== model.view.ping) model.show({ ping, cell: null });
    return;
  }
  const { recent } = model.pings;
  const at = model.view.heldAt ?? model.state?.t ?? 0;
  let index = recent.findIndex((p) => p.t > at) - 1;
  if (index < -1) index = recent.length - 1;
  const ping = recent[Math.max(0, Math.min(recent.length - 1, index + by))];
  if (ping) hold(app, ping.t);
}
