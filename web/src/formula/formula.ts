// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** A formula with the numbers of one cell. */
import type { Formula, Term } from '../protocol/messages.ts';
import { layOut } from './layout.ts';
import { quantity, signedDecimals } from './numbers.ts';
import { type Piece, spokenText, text } from './pieces.ts';

export interface FormulaOptions {
  /** Results that are changes, or what a sum of changes has come to, always carry their sign. */
  signed: boolean;
}

/** `pieces` equal `result`. */
export interface FormulaLine { words: string; pieces: readonly Piece[]; result: Extract<Piece, { kind: 'value' }>; spoken: string }

const isSum = (name: string): boolean => name === 'after' || name.endsWith('_added');

function resultOf(term: Term, { signed }: FormulaOptions): Extract<Piece, { kind: 'value' }> {
  const written = quantity(term.value, term.unit);
  const hasSign = signed && term.value !== null && isSum(term.name) && Math.abs(term.value) >= 0.005;
  return { kind: 'value', spoken: written.spoken, name: term.name, text: hasSign ? signedDecimals(term.value ?? 0, 2) : written.text };
}

/** `symbol = val result` says nothing beyond the result. */
function saysOnlyResult(tree: readonly unknown[], result: string): boolean {
  const right = tree[2];
  return tree[0] === 'eq' && tree.length === 3 && Array.isArray(right) && right[0] === 'val' && right[1] === result;
}

/** Null where the formula does not apply: the cell has no term for its result. */
export function formulaLine(formula: Formula, terms: readonly Term[], options: FormulaOptions = { signed: false }): FormulaLine | null {
  const term = terms.find(({ name }) => name === formula.result);
  if (!term) return null;
  const tree = saysOnlyResult(formula.tree, formula.result) ? formula.tree[1] : formula.tree;
  const pieces = layOut(tree, terms);
  const result = resultOf(term, options);
  return { words: formula.words, pieces, result, spoken: `${formula.words}: ${spokenText([...pieces, text(' = '), result])}` };
}
