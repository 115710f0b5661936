// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Numbers of formulas, facts and tables, with their units, in the digits that tell something. */

/** What is read, and what a screen reader says. */
export interface Written { text: string; spoken: string }

const unknown: Written = { text: '–', spoken: 'unknown' };
const degreesPerRadian = 180 / Math.PI;
const superscripts = '⁰¹²³⁴⁵⁶⁷⁸⁹';
/** Units that say what a number is, not what it is counted in. */
const silentUnits = new Set(['', 'p', 'log-odds', 'evidence', 'certainty']);

/** A number with so many decimals, the minus sign of print, and never "−0.00". */
export function decimals(value: number, digits: number): string {
  const text = value.toFixed(digits);
  return Number(text) === 0 ? text.replace('-', '') : text.replace('-', '−');
}

/** The same with its sign always. */
export function signedDecimals(value: number, digits: number): string {
  const text = decimals(value, digits);
  return text.startsWith('−') || Number(text) === 0 ? text : `+${text}`;
}

function powerOfTen(exponent: number): string {
  const digits = [...String(Math.abs(exponent))].map((d) => superscripts[Number(d)] ?? d).join('');
  return `10${exponent < 0 ? '⁻' : ''}${digits}`;
}

/** Two decimals where they tell something, else two significant digits; whole numbers whole. */
export function plainNumber(value: number): string {
  const size = Math.abs(value);
  if (Number.isInteger(value) && size < 1e9) return value.toLocaleString('en-US').replace('-', '−');
  if (size >= 1e6 || size < 1e-3) {
    const exponent = Math.floor(Math.log10(size));
    return `${decimals(value / 10 ** exponent, 1)} · ${powerOfTen(exponent)}`;
  }
  if (size >= 100) return decimals(value, 1);
  return size >= 0.1 ? decimals(value, 2) : Number(value.toPrecision(2)).toString().replace('-', '−');
}

/** A constant of a formula: up to four significant digits, none of them a zero at the end. */
export function constantNumber(value: number): string {
  if (value === 0 || !Number.isFinite(value)) return value === 0 ? '0' : unknown.text;
  const size = Math.abs(value);
  return size >= 1e6 || size < 1e-4 ? plainNumber(value) : Number(value.toPrecision(4)).toString().replace('-', '−');
}

function spokenNumber(text: string): string {
  return text.replace('−', 'minus ').replaceAll(',', '').replace(' · 10', ' times ten to the power ').replace(/⁻/, 'minus ')
    .replace(/[⁰¹²³⁴⁵⁶⁷⁸⁹]/g, (d) => String(superscripts.indexOf(d)));
}

function withUnit(number: string, unit: string, spoken: string): Written {
  return { text: unit === '°' ? `${number}°` : unit === '' ? number : `${number} ${unit}`, spoken: `${spokenNumber(number)}${spoken === '' ? '' : ` ${spoken}`}` };
}

type Writer = (value: number) => string;

function inUnit(value: number, unit: string, shortNumber: Writer, asLength: Writer): Written {
  const size = Math.abs(value);
  switch (unit) {
    case 'rad': return inUnit(value * degreesPerRadian, 'deg', shortNumber, asLength);
    case 'deg':
    case '°': return withUnit(shortNumber(value), '°', 'degrees');
    case 'm': return size < 0.2 ? withUnit(shortNumber(value * 100), 'cm', 'centimetres') : withUnit(asLength(value), 'm', 'metres');
    case 's': return size < 0.1 ? withUnit(asLength(value * 1000), 'ms', 'milliseconds') : withUnit(asLength(value), 's', 'seconds');
    default: return silentUnits.has(unit) ? withUnit(plainNumber(value), '', '') : withUnit(plainNumber(value), unit, unit);
  }
}

/** A measured or computed value: angles in degrees, lengths in centimetres or metres as reads best. */
export function quantity(value: number | null, unit: string): Written {
  if (value === null || !Number.isFinite(value)) return unknown;
  return inUnit(value, unit, (v) => decimals(v, 1), (v) => decimals(v, 3));
}

/** A constant in a unit. */
export function constant(value: number, unit = ''): Written {
  if (unit === '' || !Number.isFinite(value)) return withUnit(constantNumber(value), '', '');
  return inUnit(value, unit, constantNumber, constantNumber);
}

/** A direction between -180 and 180 degrees. */
export function direction(rad: number): string {
  return degrees(Math.atan2(Math.sin(rad), Math.cos(rad)));
}

export const degrees = (rad: number, digits = 1): string => `${decimals(rad * degreesPerRadian, digits)}°`;
export const signedDegrees = (rad: number, digits = 1): string => `${signedDecimals(rad * degreesPerRadian, digits)}°`;
export const metres = (m: number | null): string => (m === null ? unknown.text : `${decimals(m, 2)} m`);
export const centimetres = (m: number, digits = 1): string => `${decimals(m * 100, digits)} cm`;
export const place = (x: number, y: number): string => `${decimals(x, 2)}, ${decimals(y, 2)}`;
export const count = (n: number): string => Math.round(n).toLocaleString('en-US');

/** Length of something that is looked at: centimetres below a metre. */
export const length = (m: number): string => (Math.abs(m) < 1 ? centimetres(m, Math.abs(m) < 0.1 ? 1 : 0) : metres(m));

/** Time of the source with hundredths: 1:26.52. */
export function exactTime(seconds: number): string {
  const hundredths = Math.max(0, Math.round(seconds * 100));
  const rest = hundredths % 6000;
  return `${Math.floor(hundredths / 6000)}:${String(Math.floor(rest / 100)).padStart(2, '0')}.${String(rest % 100).padStart(2, '0')}`;
}
