// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** What the open step says: sentences, formulas with this ping's numbers, tables. */
import { formulaLine } from '../formula/formula.ts';
import { count, metres, place } from '../formula/numbers.ts';
import { formulaBox } from '../formula/typeset.ts';
import type { Rejection, Stepped } from '../protocol/messages.ts';
import { h, type Child } from '../ui/dom.ts';
import { icon } from '../ui/icons.ts';
import { type Cell, cellRank, gain } from './cells.ts';
import { changeCounts, type PartLine, speaksOfCells } from './parts.ts';
import { beforeAfter, reasonText, words } from './words.ts';

export interface BodyContext {
  cell: Cell | null;
  truePose: boolean;
  rejections: readonly Rejection[];
  moveCell(by: number): void;
}

const shownArcs = 40;
const p = (text: string, kind: string | null = null): HTMLElement => h('p', { class: kind }, text);

function rangeBox(s: Stepped, line: PartLine): HTMLElement {
  return h('div', { class: 'fx' }, [h('span', { class: 'fx-words' }, words.rangeWords), h('div', { class: 'fx-line' }, [line.line, h('strong', {}, line.strong)])]);
}

function whyNot(s: Stepped, rejections: readonly Rejection[]): Child[] {
  const known = rejections.find((r) => r.name === s.ping.reason);
  const [what, why] = [words.rejectedFor(s.ping.reason ?? s.reason), reasonText(known?.explanation ?? s.reason)];
  return [h('p', { class: 'step-rejected' }, what), why === what ? null : p(why),
    known && known.remedy !== '' ? h('p', { class: 'hint' }, reasonText(known.remedy)) : null];
}

function echoBody(s: Stepped, line: PartLine, { rejections }: BodyContext): Child[] {
  const way = (s.ping.tx === s.ping.rx ? words.thereAndBack : words.wayOfTwo)(s.time_of_flight_s ?? 0);
  const heard: Child[] = line.strong === '' ? [p(line.line === '' ? `${words.noRange}` : line.line)] : [p(way), rangeBox(s, line)];
  return s.ping.outcome === 'rejected' ? [...heard, ...whyNot(s, rejections)] : heard;
}

function sensorBody(s: Stepped, line: PartLine, { truePose }: BodyContext): Child[] {
  const [x, y, yaw] = s.ping.T_world_robot;
  const two = s.ping.tx === s.ping.rx ? null : p(words.twoSensors(s.ping.rx, s.ping.T_world_rx[0], s.ping.T_world_rx[1]));
  const truth = truePose && s.true_pose;
  const turn = truth ? Math.atan2(Math.sin(truth[2] - yaw), Math.cos(truth[2] - yaw)) : 0;
  return [p(`${line.line}.`), two, p(words.robotAt(x, y, yaw)), truth ? h('p', { class: 'hint' }, words.whatIf(Math.hypot(truth[0] - x, truth[1] - y), turn)) : null];
}

function arcBody(s: Stepped, line: PartLine): Child[] {
  return s.arc ? [p(`${line.line}.`), p(words.fromTo(s.arc.t_begin, s.arc.t_end))] : [p(line.line)];
}

function countsLine(s: Stepped): HTMLElement {
  const { fuller, emptier, same } = changeCounts(s);
  const parts: Child[] = [];
  if (fuller > 0) parts.push(h('b', { class: 'step-fuller' }, words.cells(fuller)), words.getFuller(fuller));
  if (fuller > 0 && emptier > 0) parts.push(', ');
  if (emptier > 0) parts.push(h('b', { class: 'step-emptier' }, words.cells(emptier)), words.getEmptier(emptier));
  if (same > 0) parts.push(words.stay(same));
  return h('p', {}, [...parts, '. ', words.clickCell]);
}

function cellsBody(s: Stepped, { cell, moveCell }: BodyContext): Child[] {
  if (!cell) return [p(words.cells(0))];
  const boxes = s.formulas.map((formula) => formulaLine(formula, cell.terms, { signed: s.unit === 'log-odds' })).filter((line) => line !== null).map(formulaBox);
  const held = beforeAfter(cell.before, cell.after, s.unit);
  const turn = (by: number, label: string): HTMLElement => h('button', { class: by < 0 ? 'mini' : 'mini step-flip', 'aria-label': label, title: label, 'data-key': label }, [icon('back')], { click: () => moveCell(by) });
  const row = h('div', { class: 'step-cell' }, [h('span', {}, words.outlined), h('span', { class: 'step-rank' }, words.cellNumber(cellRank(s.cells, cell), s.cells.length)),
    turn(-1, words.previousCell), turn(1, words.nextCell)]);
  return [countsLine(s), row, ...boxes, h('p', { class: 'step-held' }, [held.before, h('b', { class: gain(cell, s.unit) > 0 ? 'step-fuller' : 'step-emptier' }, held.after), ' after'])];
}

function arcsBody(s: Stepped): Child[] {
  const rows = s.arcs.slice(0, shownArcs).map(({ ping, what, note }) => h('tr', {}, [h('td', {}, count(ping.ping)), h('td', {}, String(ping.rx)), h('td', {}, metres(ping.range_m)), h('td', { class: 'explain-note' }, words.happens(what, note))]));
  const head = words.columns.map((name, i) => h('th', { scope: 'col', class: i === words.columns.length - 1 ? 'left' : null }, name));
  return [h('table', { class: 'explain-support' }, [h('thead', {}, [h('tr', {}, head)]), h('tbody', {}, rows)]), s.arcs.length > shownArcs ? p(words.moreArcs(s.arcs.length - shownArcs), 'small') : null];
}

function pointsLine(s: Stepped): HTMLElement | null {
  return s.points.length === 0 ? null : p(words.pointsAt(s.points.map(([x, y]) => place(x, y)).join('; ')));
}

function afterBody(s: Stepped): Child[] {
  const isTold = !speaksOfCells(s) && s.arcs.length === 0;
  return isTold ? [p(words.mapMoved)] : [s.summary === '' ? null : p(s.summary), pointsLine(s), p(words.mapMoved)];
}

export function bodyOf(s: Stepped, line: PartLine, context: BodyContext): Child[] {
  if (line.value === words.notUsed) return [p(reasonText(s.reason))];
  switch (line.name) {
    case 'echo': return echoBody(s, line, context);
    case 'sensor': return sensorBody(s, line, context);
    case 'arc':
    case 'cone': return arcBody(s, line);
    case 'cells': return cellsBody(s, context);
    case 'arcs': return arcsBody(s);
    case 'adds': return [p(line.line), pointsLine(s)];
    case 'after': return afterBody(s);
  }
}
