// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Who drives: taking, asking, answering, handing over. */
import { h } from '../ui/dom.ts';
import type { App } from '../ui/app.ts';
import { dialog, menu } from '../ui/popover.ts';
import { capital } from '../ui/format.ts';
import { toast } from '../ui/toast.ts';
import { words } from '../words.ts';

export function driverName(app: App): string | null {
  const driver = app.model.state?.driver ?? null;
  if (driver === null) return null;
  return app.model.viewers?.viewers.find((v) => v.viewer === driver)?.name ?? `Viewer ${driver}`;
}

export function askForToken(app: App): void {
  const field = h('input', { class: 'field', 'aria-label': 'Token', autocomplete: 'off', spellcheck: 'false' });
  const form = h('form', {}, [h('p', {}, words.tokenDialog), h('div', { class: 'row' }, [field, h('button', { class: 'btn pri', type: 'submit' }, 'Use it')])]);
  const box = dialog(words.drive, [form], () => app.driving.stop());
  form.addEventListener('submit', (event) => {
    event.preventDefault();
    const text = field.value.trim();
    const token = /token=([\w-]+)/.exec(text)?.[1] ?? text;
    if (!token) return;
    box.close();
    const off = app.model.on('welcome', () => {
      off();
      if (app.model.welcome?.you.may_drive) wantToDrive(app);
      else toast(words.tokenWrong, [], true);
    });
    app.model.useToken(token);
  });
}

export function wantToDrive(app: App): void {
  if (!app.model.welcome?.you.may_drive) askForToken(app);
  else if (app.driving.active) app.driving.release();
  else {
    const other = driverName(app);
    app.driving.take();
    if (other !== null) toast(`Asked ${other} to hand over`);
  }
}

export function handOverMenu(app: App, opener: HTMLElement): void {
  const others = (app.model.viewers?.viewers ?? []).filter((v) => v.viewer !== app.model.me);
  menu(opener, words.handOver, [
    ...others.map((v) => ({ label: v.name, run: () => app.driving.release(v.viewer) })),
    { label: words.nobody, run: () => app.driving.release() },
  ]);
}

export function followRights(app: App): void {
  app.model.on('drive_request', () => {
    const request = app.model.driveRequest;
    if (!request) return;
    const answer = (accept: boolean) => (): void => { app.model.send({ type: 'answer', accept }); };
    toast(words.asksToDrive(request.name), [
      { label: words.handOver, primary: true, run: answer(true) }, { label: words.keep, run: answer(false) },
    ], false, 1000 * request.timeout_s); // after that the server takes no answer for Keep
  });
  app.model.on('drive_lost', () => {
    const reason = app.model.driveLost?.reason;
    if (reason === 'dead_man') toast(words.lostDriving, [{ label: words.driveAgain, run: () => app.driving.take() }]);
    else if (reason === 'kept') toast('The driver keeps driving.');
    else if (reason === 'handed_over') toast('You handed over.');
  });
  app.model.on('refused', () => {
    const refusal = app.model.refused;
    // Commands that were on their way when the right to drive went are no news: drive_lost says it.
    if (refusal?.code === 'unsupported' && app.driving.isWindingDown) return;
    if (refusal) toast([refusal.message, refusal.remedy].filter(Boolean).map((text) => capital(text)).join('. '), [], true);
  });
}
