// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Numbers as the page writes them. */
export const dash = '–';
export const signed = (text: string): string => text.replace('-', '−');
export const whole = (value: number): string => signed(Math.round(value).toLocaleString('en-US'));
export const fixed = (value: number, digits: number): string => signed(value.toFixed(digits));

export function centimetres(metres: number | null, digits = 1): string {
  return metres === null || !Number.isFinite(metres) ? dash : `${fixed(metres * 100, metres >= 0.1 ? Math.min(digits, 1) : digits)} cm`;
}

export function clock(seconds: number): string {
  const total = Math.max(0, Math.floor(seconds));
  const rest = String(total % 60).padStart(2, '0');
  const minutes = Math.floor(total / 60);
  return minutes < 60 ? `${minutes}:${rest}` : `${Math.floor(minutes / 60)}:${String(minutes % 60).padStart(2, '0')}:${rest}`;
}

export function spokenTime(seconds: number): string {
  const total = Math.max(0, Math.floor(seconds));
  const minutes = Math.floor(total / 60);
  const part = (n: number, word: string): string => `${n} ${word}${n === 1 ? '' : 's'}`;
  return minutes === 0 ? part(total % 60, 'second') : `${part(minutes, 'minute')} ${total % 60}`;
}

export function share(part: number, of: number): string {
  if (of === 0) return '';
  return `${fixed((100 * part) / of, part / of < 0.1 && part > 0 ? 1 : 0)}%`;
}

export function size(bytes: number): string {
  if (bytes < 1000) return `${bytes} B`;
  return bytes < 1e6 ? `${whole(bytes / 1000)} kB` : `${whole(bytes / 1e6)} MB`;
}

export const capital = (text: string): string => text.charAt(0).toUpperCase() + text.slice(1);
/** Names on the wire in words: "range_jump" is "range jump". */
export const words = (name: string): string => name.replaceAll('_', ' ');

const compass = ['east', 'north-east', 'north', 'north-west', 'west', 'south-west', 'south', 'south-east'];
export const heading = (yawRad: number): string => compass[((Math.round((yawRad * 4) / Math.PI) % 8) + 8) % 8] ?? 'east';
