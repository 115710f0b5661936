// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

import { describe, expect, test } from 'vitest';
import { formulaLine } from '../../src/formula/formula.ts';
import { layOut } from '../../src/formula/layout.ts';
import { isTall, plainText, spokenText } from '../../src/formula/pieces.ts';
import type { Term } from '../../src/protocol/messages.ts';

const term = (name: string, value: number | null, unit = ''): Term => ({ name, value, unit });
const terms = [term('theta', 0.0366519, 'rad'), term('p', 0.71), term('before', 1.61), term('after', 2.51), term('low', -0.4), term('none', null), term('sigma', 1.44, 'm')];
const sym = (name: string): unknown[] => ['sym', name];
const val = (name: string): unknown[] => ['val', name];
const num = (n: number, unit?: string): unknown[] => (unit === undefined ? ['num', n] : ['num', n, unit]);
const line = (tree: unknown): string => plainText(layOut(tree, terms));

describe('layout', () => {
  test.each([
    [['add', num(1), num(2)], '1 + 2'],
    [['sub', num(1), ['sub', num(2), num(3)]], '1 − (2 − 3)'],
    [['sub', ['sub', num(1), num(2)], num(3)], '1 − 2 − 3'],
    [['add', num(1), ['sub', num(2), num(3)]], '1 + 2 − 3'],
    [['mul', ['add', num(1), num(2)], num(3)], '(1 + 2) · 3'],
    [['add', ['mul', num(1), num(2)], num(3)], '1 · 2 + 3'],
    [['add', num(1), val('low')], '1 + (−0.40)'],
    [['add', val('low'), num(1)], '−0.40 + 1'],
    [['mul', num(2), val('low')], '2 · (−0.40)'],
    [['pow', ['frac', val('theta'), num(6.25)], num(2)], '(2.1°/6.25)^2'],
    [['pow', val('low'), num(2)], '(−0.40)^2'],
    [['pow', ['pow', num(2), num(3)], num(4)], '(2^3)^4'],
    [['neg', ['add', num(1), num(2)]], '−(1 + 2)'],
    [['neg', ['frac', num(1), num(3)]], '−1/3'],
    [['frac', ['add', num(1), num(2)], ['sub', num(1), val('p')]], '(1 + 2)/(1 − 0.71)'],
    [['exp', ['neg', val('p')]], 'exp(−0.71)'],
    [['ln', ['frac', val('p'), ['sub', num(1), val('p')]]], 'ln 0.71/(1 − 0.71)'],
    [['ln', ['add', num(1), num(2)]], 'ln(1 + 2)'],
    [['exp', ['neg', ['frac', ['pow', ['frac', val('theta'), num(6.25, 'deg')], num(2)], num(2)]]], 'exp(−½(2.1°/6.25°)^2)'],
    [['frac', val('p'), num(2)], '½ · 0.71'],
    [['sub', val('sigma'), num(1.4399999, 'm')], '1.440 m − 1.44 m'],
    [['eq', sym('C_f'), ['mul', val('p'), num(3)]], 'C_f = 0.71 · 3'],
  ])('%j is %s', (tree, expected) => expect(line(tree)).toBe(expected));

  test('a fraction is higher than a line, and so is all around it', () => {
    expect(isTall(layOut(['pow', ['frac', num(1), num(3)], num(2)], []))).toBe(true);
    expect(isTall(layOut(['pow', num(1), num(2)], []))).toBe(false);
  });

  test('what is not known is written, never thrown', () => {
    expect(line(['sqrt', num(2), val('p')])).toBe('sqrt(2, 0.71)');
    expect(line(val('missing'))).toBe('missing');
    expect(line(val('none'))).toBe('–');
    expect(line(['frac', num(1)])).toBe('frac(1)');
    expect(line(['add'])).toBe('add()');
    for (const tree of [null, undefined, 3, 'x', [], [[]], {}, ['num'], ['num', 'x'], ['val'], ['eq', null], ['exp', num(1), num(2)]]) expect(() => line(tree)).not.toThrow();
    let deep: unknown = num(1);
    for (let i = 0; i < 10000; i++) deep = ['neg', deep];
    expect(line(deep)).toContain('…');
  });

  test('it is read aloud', () => {
    expect(spokenText(layOut(['eq', sym('w'), ['exp', ['neg', ['pow', ['frac', val('theta'), num(6.25)], num(2)]]]], terms)))
      .toBe('w equals the exponential of open bracket minus open bracket 2.1 degrees over 6.25 close bracket squared close bracket');
  });
});

describe('formula of a cell', () => {
  const added = { words: 'Added to what the cell held', tree: ['eq', sym('after'), ['add', val('before'), ['ln', val('p')]]], result: 'after' };

  test('ends with its result', () => {
    const made = formulaLine(added, terms, { signed: true });
    expect(made && `${plainText(made.pieces)} = ${made.result.text}`).toBe('after = 1.61 + ln 0.71 = +2.51');
    expect(made?.spoken).toBe('Added to what the cell held: after equals 1.61 plus the natural logarithm of 0.71 equals 2.51');
    expect(formulaLine(added, terms)?.result.text).toBe('2.51');
  });

  test('does not say the result twice', () => {
    const made = formulaLine({ words: '', tree: ['eq', sym('p'), val('p')], result: 'p' }, terms);
    expect(made && `${plainText(made.pieces)} = ${made.result.text}`).toBe('p = 0.71');
  });

  test('applies only to cells that have its result', () => expect(formulaLine({ ...added, result: 'p_band' }, terms)).toBeNull());
});
