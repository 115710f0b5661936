// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** The sections of the panel that explains a point or a cell. */
import { unitWords } from '../formula/fullness.ts';
import { centimetres, decimals, place, plainNumber, signedDecimals } from '../formula/numbers.ts';
import type { MarkSlot } from '../map/slots.ts';
import type { Explanation } from '../protocol/messages.ts';
import { h, svg, type Child } from '../ui/dom.ts';
import { barSize, cellBars, type CellBar, type CellHistory } from './cell_bars.ts';
import { figureView } from './figure_view.ts';
import { isWords, supportTable, type Column, type SupportRow } from './support_table.ts';
import { cellState, words } from './words.ts';

/** Told which supporting ping is looked at; null: none. */
export type Hover = (ping: number | null) => void;

function section(title: string, right: string, children: readonly Child[]): HTMLElement {
  return h('section', { class: 'sec' }, [h('h2', {}, [title, right !== '' && h('span', { class: 'r' }, right)]), ...children]);
}

const fact = (value: string, name: string): HTMLElement => h('div', {}, [h('b', {}, value), h('small', {}, name)]);

/** To the millimetre below a decimetre. */
const shortLength = (m: number): string => centimetres(m, m < 0.1 ? 1 : 0);

export function titleOf({ kind, probability }: Explanation): string {
  return kind === 'point' ? words.whyPoint : words.whyCell(cellState(probability));
}

export function factsOf(e: Explanation): HTMLElement {
  const facts = [fact(place(e.x, e.y), words.place)];
  if (e.kind === 'cell') {
    if (e.cell) facts.push(fact(e.cell.unit === 'log-odds' ? signedDecimals(e.cell.value, 2) : plainNumber(e.cell.value), words.value(e.cell.unit)));
    if (e.probability !== null) facts.push(fact(`p = ${decimals(e.probability, 2)}`, words.occupied));
  } else {
    facts.push(e.bound_m === null ? fact('–', words.noBound) : fact(`±${shortLength(e.bound_m)}`, words.bound));
    if (e.off_wall_m !== null) facts.push(fact(shortLength(e.off_wall_m), words.offWall));
    else if (e.probability !== null && e.probability < 1) facts.push(fact(`${decimals(100 * e.probability, 0)}%`, words.sure));
  }
  return h('div', { class: 'facts explain-facts' }, facts);
}

export function figureSection(e: Explanation, slot: MarkSlot, name: string): HTMLElement | null {
  const figure = figureView(e, slot, name);
  return figure && e.own && section(words.alongArc(e.own.ping), '', [figure]);
}

function headCell(column: Column): HTMLElement {
  const title = column === 'bearing' || column === 'angle' ? words.columnTitles[column] : null;
  return h('th', { scope: 'col', title, class: isWords(column) ? 'left' : null }, words.columns[column]);
}

function supportRow(row: SupportRow, columns: readonly Column[], hover: Hover): HTMLElement {
  const cells = row.cells.map((content, i) => h('td', { class: isWords(columns[i]) ? 'explain-note' : null }, content));
  return h('tr', { tabindex: 0, class: row.strong ? 'own' : null, 'data-ping': row.ping, 'data-key': `ping-${row.ping}`, title: columns.some(isWords) || row.spoken === '' ? null : row.spoken }, cells, {
    mouseenter: () => hover(row.ping), mouseleave: () => hover(null), focus: () => hover(row.ping), blur: () => hover(null),
  });
}

function unusedLines({ unused }: Explanation): HTMLElement | null {
  if (unused.length === 0) return null;
  return h('ul', { class: 'explain-unused' }, unused.map(({ reason, count }) => h('li', {}, words.unused(count, reason))));
}

export function supportSection(e: Explanation, hover: Hover): HTMLElement | null {
  const table = supportTable(e.support);
  const lines = unusedLines(e);
  if (!table) return lines && section(words.notUsed, '', [lines]);
  const body = table.rows.map((row) => supportRow(row, table.columns, hover));
  return section(table.title, '', [
    h('table', { class: 'explain-support' }, [h('thead', {}, [h('tr', {}, table.columns.map(headCell))]), h('tbody', {}, body)]),
    table.legend !== '' && h('p', { class: 'small' }, table.legend),
    lines && h('h3', { class: 'explain-sub' }, words.notUsed), lines,
  ]);
}

function barRow(bar: CellBar): HTMLElement {
  const { width, height, half } = barSize;
  const wide = half * bar.share;
  const drawn = svg('svg', { class: 'explain-bar', viewBox: `0 0 ${width} ${height}`, width, height, role: 'img', 'aria-label': words.barOf(bar.ping, bar.text) }, [
    svg('path', { class: 'bar-zero', d: `M${width / 2} 0v${height}` }),
    svg('rect', { class: bar.isFuller ? 'bar-fuller' : 'bar-emptier', x: bar.change > 0 ? width / 2 : width / 2 - wide, y: 2, width: wide, height: height - 4, rx: 1 }),
  ]);
  return h('tr', {}, [h('td', {}, plainNumber(bar.ping)), h('td', { class: 'explain-where' }, words.where[bar.where]), h('td', {}, [drawn]), h('td', {}, bar.text)]);
}

function totalText(cell: CellHistory, shown: number): string {
  const holds = cell.unit === 'log-odds' ? words.sum(cell.value) : words.holds(`${plainNumber(cell.value)}${cell.unit === '' || cell.unit === 'p' ? '' : ` ${unitWords(cell.unit)}`}`);
  return words.latest(shown, cell.total) + holds;
}

export function cellSection(e: Explanation, methodTitle: (method: string) => string): HTMLElement | null {
  const { cell } = e;
  if (!cell) return null;
  const bars = cellBars(cell);
  const isUnder = e.kind === 'point';
  const title = isUnder ? words.cellUnder : words.cellChanges;
  const right = isUnder ? words.cellAtP(cellState(cell.probability), cell.probability) : methodTitle(cell.method);
  if (bars.length === 0) return section(title, right, [h('p', { class: 'small' }, words.nothingChanged)]);
  return section(title, right, [h('table', { class: 'explain-cell' }, [h('tbody', {}, bars.map(barRow))]), h('p', { class: 'small' }, totalText(cell, bars.length))]);
}

/** Lights up what belongs to a ping, in the table and in the figure. */
export function lightUp(host: HTMLElement, ping: number | null): void {
  for (const element of host.querySelectorAll('[data-ping]')) {
    const on = ping !== null && element.getAttribute('data-ping') === String(ping);
    element.classList.toggle('hov', on);
    if (on && element instanceof SVGElement) element.parentNode?.append(element);
  }
}
