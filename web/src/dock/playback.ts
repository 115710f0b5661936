// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Time of the view: live, held, stepping through pings; and playing a log. */
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
  const { recent } = app.model.pings;
  const at = app.model.view.heldAt ?? app.model.state?.t ?? 0;
  let index = recent.findIndex((p) => p.t > at) - 1;
  if (index < -1) index = recent.length - 1;
  const ping = recent[Math.max(0, Math.min(recent.length - 1, index + by))];
  if (!ping) return;
  hold(app, ping.t);
  if (app.model.view.name === 'step') app.model.show({ ping: ping.id });
}
