// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

import type { Option } from '../protocol/messages.ts';
import { capital, words as plain } from '../ui/format.ts';

export type Value = boolean | number | string;

/** Units as people read them: small lengths in centimetres, angles in degrees. */
export function displayUnit(option: Option): { factor: number; unit: string } {
  if (option.unit === 'm' && Math.abs(Number(option.default)) < 0.5 && (option.max ?? 1) <= 1) return { factor: 100, unit: 'cm' };
  if (option.unit === 'rad') return { factor: 180 / Math.PI, unit: '°' };
  return { factor: 1, unit: option.unit === '1' ? '' : option.unit };
}

/** The name in words, without the unit that stands in the field. */
export const optionTitle = (option: Option): string => capital(plain(option.unit && option.unit !== '1' && option.name.endsWith(`_${option.unit.toLowerCase()}`) ? option.name.slice(0, -option.unit.length - 1) : option.name));

export function shownNumber(option: Option, value: number): string {
  return String(Number((value * displayUnit(option).factor).toPrecision(6))).replace('-', '−');
}

export function isLogScale(option: Option): boolean {
  return option.min !== null && option.max !== null && option.min > 0 && option.max / option.min > 100;
}

/** Place of a value on the slider, 0 to 1. */
export function toSlider(option: Option, value: number): number {
  const { min, max } = option;
  if (min === null || max === null || max <= min) return 0;
  return isLogScale(option) ? Math.log(value / min) / Math.log(max / min) : (value - min) / (max - min);
}

export function fromSlider(option: Option, place: number): number {
  const { min, max } = option;
  if (min === null || max === null) return Number(option.default);
  const value = isLogScale(option) ? min * (max / min) ** place : min + (max - min) * place;
  return option.kind === 'integer' ? Math.round(value) : Number(value.toPrecision(4));
}

/** What was typed, in the unit of the wire, or what is wrong with it. */
export function parseNumber(option: Option, text: string): { value: number } | { error: string } {
  const { factor, unit } = displayUnit(option);
  const typed = Number(text.trim().replace('−', '-').replace(',', '.'));
  const from = option.min === null ? 'any' : shownNumber(option, option.min);
  const to = option.max === null ? 'any' : shownNumber(option, option.max);
  const range = `From ${from} to ${to}${unit ? ` ${unit}` : ''}`;
  if (text.trim() === '' || !Number.isFinite(typed)) return { error: range };
  const value = typed / factor;
  const slack = 1e-9 * Math.max(1, Math.abs(value));
  if ((option.min !== null && value < option.min - slack) || (option.max !== null && value > option.max + slack)) return { error: range };
  if (option.kind === 'integer' && !Number.isInteger(typed)) return { error: `${range}, whole numbers` };
  return { value };
}

/** Those that differ from their defaults: what is sent. */
export function changedOptions(options: readonly Option[], values: Readonly<Record<string, Value>>): Record<string, Value> {
  const changed: Record<string, Value> = {};
  for (const option of options) {
    const value = values[option.name];
    if (value !== undefined && value !== option.default) changed[option.name] = value;
  }
  return changed;
}
