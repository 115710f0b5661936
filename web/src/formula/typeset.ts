// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Draws laid out formulas with elements; all text is text. */
import { h } from '../ui/dom.ts';
import type { FormulaLine } from './formula.ts';
import { isTall, type Piece } from './pieces.ts';

function bracket(inside: readonly Piece[]): Node[] {
  const tall = isTall(inside);
  const side = (sign: string): Node => (tall ? h('span', { class: 'fx-tall' }, sign) : document.createTextNode(sign));
  return [h('span', { class: 'fx-group' }, [side('('), ...nodes(inside), side(')')])];
}

function nodesOf(piece: Piece): Node[] {
  switch (piece.kind) {
    case 'text': return [document.createTextNode(piece.text)];
    case 'symbol': return [h('em', {}, [piece.text, piece.lower !== '' && h('sub', {}, piece.lower)])];
    case 'value': return [h('span', { class: 'fx-value', title: piece.name === '' ? null : piece.name.replaceAll('_', ' ') }, piece.text)];
    case 'function': return [document.createTextNode(piece.name)];
    case 'fraction': return [h('span', { class: 'fx-fraction' }, [h('span', {}, nodes(piece.over)), h('span', {}, nodes(piece.under))])];
    case 'power': return [...nodes(piece.base), h('sup', { class: isTall(piece.base) ? 'fx-high' : null }, nodes(piece.exponent))];
    case 'bracket': return bracket(piece.inside);
  }
}

/** A function stays on one line with what it is applied to. */
function nodes(pieces: readonly Piece[]): Node[] {
  const all: Node[] = [];
  for (let i = 0; i < pieces.length; i++) {
    const piece = pieces[i] as Piece;
    if (piece.kind !== 'function') { all.push(...nodesOf(piece)); continue; }
    const end = pieces[i + 1]?.kind === 'text' ? i + 3 : i + 2;
    all.push(h('span', { class: 'fx-group' }, pieces.slice(i, end).flatMap(nodesOf)));
    i = end - 1;
  }
  return all;
}

/** A box with the words and the line below them. */
export function formulaBox(line: FormulaLine): HTMLElement {
  const drawn = h('div', { class: 'fx-line', role: 'math', 'aria-label': line.spoken }, [...nodes(line.pieces), ' ', h('span', { class: 'fx-group' }, ['= ', h('strong', {}, line.result.text)])]);
  return h('div', { class: 'fx' }, [h('span', { class: 'fx-words' }, line.words), drawn]);
}
