// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** The mode in words, and the menu that starts another. */
import { askForToken, driverName, handOverMenu } from '../drive/rights.ts';
import type { State } from '../protocol/messages.ts';
import { menuModes, modeAction, modeEnded, modeNow, words } from '../words.ts';
import type { App } from './app.ts';
import { h, say } from './dom.ts';
import { fixed } from './format.ts';
import { icon, type IconName } from './icons.ts';
import { menu } from './popover.ts';
import { toast } from './toast.ts';

const icons: Record<string, IconName> = {
  frontier: 'frontier', gvg: 'graph', 'wall-left': 'wallLeft', 'wall-right': 'wallRight', goto: 'point', home: 'home', tour: 'tour', stand: 'stand',
};

export function mountModeChip(app: App, over: HTMLElement, startGoTo: () => void): void {
  const mode = h('span'), doing = h('small', { class: 'doing' }), speed = h('small'), hand = h('button', { class: 'btn sm' }, words.handOver);
  const driving = h('span', {}, words.youDrive);
  const chip: HTMLButtonElement = h('button', { class: 'chip', 'aria-haspopup': 'menu', hidden: true }, [h('span', { class: 'rb' }), mode, doing, speed, icon('chev')]);
  const mine = h('div', { class: 'chip mine', hidden: true }, [h('span', { class: 'dot' }), driving, hand]);
  over.append(chip, mine);
  hand.addEventListener('click', () => handOverMenu(app, hand));
  chip.addEventListener('click', () => openMenu(app, chip, startGoTo));
  const tellEnd = endTeller();
  app.model.on('state', () => {
    const s = app.model.state;
    if (!s) return;
    chip.hidden = app.driving.active;
    mine.hidden = !app.driving.active;
    const log = app.model.welcome?.source.kind === 'log';
    chip.disabled = log;
    const isBlocked = s.limited_by === 'obstacle' && s.limit_m_s < 0.02 && s.free_ahead_m !== null;
    say(driving, isBlocked ? words.obstacleAhead((s.free_ahead_m ?? 0) * 100) : words.youDrive);
    const driver = driverName(app);
    if (log) say(mode, s.playing ? words.playsLog : words.logPaused);
    else say(mode, driver ? `${driver} drives` : s.reason === 'obstacle' && s.free_ahead_m !== null && s.detail === '' ? words.obstacle(s.free_ahead_m * 100) : modeNow(s.mode));
    say(doing, s.detail);
    doing.title = s.detail;
    say(speed, `${fixed(Math.abs(s.v), 2)} m/s`);
    tellEnd(s);
  });
}

function openMenu(app: App, chip: HTMLElement, startGoTo: () => void): void {
  const { welcome } = app.model;
  if (!welcome?.you.may_drive) { askForToken(app); return; }
  menu(chip, 'Mode', menuModes(welcome.modes).map((mode) => ({
    label: modeAction(mode), current: mode === app.model.state?.mode,
    run: () => { if (mode === 'goto') startGoTo(); else app.model.send({ type: 'mode', mode }); },
    ...(icons[mode] === undefined ? {} : { icon: icons[mode] }),
  })));
}

/** Says once how a strategy ended that was seen driving. */
function endTeller(): (state: State) => void {
  let drove = '';
  return ({ mode, strategy, reason, detail }) => {
    const ended = reason === 'finished' || reason === 'failed';
    if (ended && drove !== '' && drove === strategy) toast(modeEnded(strategy, reason === 'finished', detail));
    drove = mode === strategy ? strategy : '';
  };
}
