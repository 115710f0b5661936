// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

import { describe, expect, test } from 'vitest';
import { constant, decimals, direction, exactTime, length, plainNumber, quantity, signedDecimals } from '../../src/formula/numbers.ts';

describe('numbers', () => {
  test.each([
    [0.0366519, 'rad', '2.1°'], [-12.5, 'deg', '−12.5°'], [0.048, 'm', '4.8 cm'], [-0.048, 'm', '−4.8 cm'], [1.4399, 'm', '1.440 m'],
    [0.00839, 's', '8.390 ms'], [2.5, 's', '2.500 s'], [0.9512, '', '0.95'], [0.0123, '', '0.012'], [0.0000123, '', '1.2 · 10⁻⁵'],
    [1, '', '1'], [3, 'arcs', '3 arcs'], [1234.56, '', '1234.6'], [12345, '', '12,345'], [2.514, 'log-odds', '2.51'], [0, '', '0'], [0, 'm', '0.0 cm'],
  ])('%d %s is %s', (value, unit, expected) => expect(quantity(value, unit).text).toBe(expected));

  test('what is not there is a dash', () => {
    for (const value of [null, Number.NaN, Number.POSITIVE_INFINITY]) expect(quantity(value, 'm').text).toBe('–');
  });

  test('they are spoken with whole words', () => {
    expect(quantity(-0.048, 'm').spoken).toBe('minus 4.8 centimetres');
    expect(quantity(0.0000123, '').spoken).toBe('1.2 times ten to the power minus 5');
    expect(quantity(12345, 'arcs').spoken).toBe('12345 arcs');
  });

  test.each([[0.35, '0.35'], [6.25, '6.25'], [1.44399999, '1.444'], [0.02, '0.02'], [2, '2'], [-0.5, '−0.5'], [0.34999999999, '0.35']])(
    'the constant %d is %s', (value, expected) => expect(constant(value).text).toBe(expected));

  test('a constant in a unit', () => {
    expect(constant(0.02, 'm').text).toBe('2 cm');
    expect(constant(6.25, 'deg').text).toBe('6.25°');
  });

  test('no negative zero', () => {
    expect(decimals(-0.001, 2)).toBe('0.00');
    expect(signedDecimals(-0.001, 2)).toBe('0.00');
    expect(signedDecimals(0.9, 1)).toBe('+0.9');
    expect(plainNumber(0)).toBe('0');
  });

  test('lengths and times', () => {
    expect(length(0.628)).toBe('63 cm');
    expect(length(0.02)).toBe('2.0 cm');
    expect(length(1.234)).toBe('1.23 m');
    expect(exactTime(86.52)).toBe('1:26.52');
    expect(exactTime(59.999)).toBe('1:00.00');
    expect(exactTime(-1)).toBe('0:00.00');
    expect(direction(4.49182)).toBe('−102.6°');
    expect(direction(-0.1)).toBe('−5.7°');
  });
});
