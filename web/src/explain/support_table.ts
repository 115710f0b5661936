// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Which columns the table of supporting pings has, and in which order its rows come. */
import { count, degrees, metres, signedDegrees } from '../formula/numbers.ts';
import type { Explanation } from '../protocol/messages.ts';
import { words } from './words.ts';

export type Support = Explanation['support'][number];
export type Column = 'ping' | 'sensor' | 'range' | 'bearing' | 'angle' | 'did' | 'says';
/** Columns of words. */
export const isWords = (column: Column | undefined): boolean => column === 'did' || column === 'says';
export interface SupportRow { ping: number; cells: string[]; strong: boolean; spoken: string }
export interface SupportTable { title: string; columns: Column[]; rows: SupportRow[]; /** What bold rows are. */ legend: string }

/** Arcs that cross it along the arc; what cut it in the order of time; others as they come, which is by weight. */
export function orderedSupport(support: readonly Support[]): Support[] {
  const isCrossed = support.some((s) => s.angle !== null);
  if (isCrossed) return [...support].sort((a, b) => (a.t ?? Number.POSITIVE_INFINITY) - (b.t ?? Number.POSITIVE_INFINITY) || a.ping.ping - b.ping.ping);
  return support.some((s) => s.t !== null) ? [...support].sort((a, b) => a.ping.t - b.ping.t || a.ping.ping - b.ping.ping) : [...support];
}

const sensorText = ({ tx, rx }: Support['ping']): string => (tx === rx ? String(rx) : `${tx} → ${rx}`);

function cellText(column: Column, { ping, t, angle, note }: Support): string {
  switch (column) {
    case 'ping': return count(ping.ping);
    case 'sensor': return sensorText(ping);
    case 'range': return metres(ping.range_m);
    case 'bearing': return t === null ? '–' : signedDegrees(t);
    case 'angle': return angle === null ? '–' : degrees(angle, 0);
    case 'did':
    case 'says': return note;
  }
}

function titleOf(n: number, crossed: boolean, cut: boolean): string {
  if (crossed) return words.crossingsUsed(n);
  return cut ? words.cutsUsed(n) : words.arcsUsed(n);
}

/** Null where no other ping stands behind it. */
export function supportTable(support: readonly Support[]): SupportTable | null {
  if (support.length === 0) return null;
  const crossed = support.some((s) => s.angle !== null);
  const cut = !crossed && support.some((s) => s.t !== null);
  const notes = new Set(support.map((s) => s.note).filter((note) => note !== ''));
  // One note that some rows have marks them; notes of their own need a column.
  const legend = crossed && notes.size === 1 && support.some((s) => s.note === '') ? [...notes][0] ?? '' : '';
  const columns: Column[] = ['ping', 'sensor', 'range'];
  if (crossed) columns.push('bearing', 'angle');
  else if (notes.size > 0) columns.push(cut ? 'did' : 'says');
  const rows = orderedSupport(support).map((s): SupportRow => ({
    ping: s.ping.ping, cells: columns.map((column) => cellText(column, s)), strong: legend !== '' && s.note !== '', spoken: s.note,
  }));
  return { title: titleOf(support.length, crossed, cut), columns, rows, legend: legend === '' ? '' : words.inBold(legend) };
}
