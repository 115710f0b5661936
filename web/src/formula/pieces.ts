// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** A formula laid out: what stands beside, above and below what. Data alone, so that it can be read, spoken and drawn. */
export type Piece =
  | { kind: 'text'; text: string }
  | { kind: 'symbol'; text: string; lower: string }
  | { kind: 'value'; text: string; spoken: string; name: string }
  | { kind: 'function'; name: string }
  | { kind: 'fraction'; over: readonly Piece[]; under: readonly Piece[] }
  | { kind: 'power'; base: readonly Piece[]; exponent: readonly Piece[] }
  | { kind: 'bracket'; inside: readonly Piece[] };

export const text = (content: string): Piece => ({ kind: 'text', text: content });

/** "C_f" is a C with an f below. */
export function symbol(name: string): Piece {
  const [head = '', ...tail] = name.split('_');
  return { kind: 'symbol', text: head, lower: tail.join(' ') };
}

/** Whether it is higher than a line, so that what stands around it must be too. */
export function isTall(pieces: readonly Piece[]): boolean {
  return pieces.some((p) => p.kind === 'fraction' || (p.kind === 'power' && isTall(p.base)) || (p.kind === 'bracket' && isTall(p.inside)));
}

const inOne = (pieces: readonly Piece[]): string => (pieces.length > 1 ? `(${plainText(pieces)})` : plainText(pieces));

/** On one line: "exp(−½(2.1°/6.25)^2)". */
export function plainText(pieces: readonly Piece[]): string {
  return pieces.map((p) => {
    switch (p.kind) {
      case 'text':
      case 'value': return p.text;
      case 'symbol': return p.lower === '' ? p.text : `${p.text}_${p.lower}`;
      case 'function': return p.name;
      case 'fraction': return `${inOne(p.over)}/${inOne(p.under)}`;
      case 'power': return `${plainText(p.base)}^${plainText(p.exponent)}`;
      case 'bracket': return `(${plainText(p.inside)})`;
    }
  }).join('');
}

const spokenSigns: Record<string, string> = {
  '=': 'equals', '+': 'plus', '−': 'minus', '·': 'times', '½': 'one half of', ',': '', '…': 'and so on',
};
const spokenFunctions: Record<string, string> = { exp: 'the exponential of', ln: 'the natural logarithm of' };
const spokenPowers: Record<string, string> = { 2: 'squared', 3: 'cubed' };

/** As a person reads it aloud. */
export function spokenText(pieces: readonly Piece[]): string {
  return pieces.map((p) => {
    switch (p.kind) {
      case 'text': return [...p.text.trim()].map((sign) => spokenSigns[sign] ?? sign).join('');
      case 'value': return p.spoken;
      case 'symbol': return p.lower === '' ? p.text : `${p.text} ${p.lower}`;
      case 'function': return spokenFunctions[p.name] ?? `${p.name} of`;
      case 'fraction': return `${spokenText(p.over)} over ${spokenText(p.under)}`;
      case 'power': return `${spokenText(p.base)} ${spokenPowers[plainText(p.exponent)] ?? `to the power ${spokenText(p.exponent)}`}`;
      case 'bracket': return `open bracket ${spokenText(p.inside)} close bracket`;
    }
  }).filter((part) => part !== '').join(' ');
}
