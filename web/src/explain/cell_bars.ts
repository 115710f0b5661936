// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** The newest changes of a cell as signed bars. */
import { fullness } from '../formula/fullness.ts';
import { plainNumber, signedDecimals } from '../formula/numbers.ts';
import type { Explanation } from '../protocol/messages.ts';

export type CellHistory = NonNullable<Explanation['cell']>;
export interface CellBar { ping: number; where: CellHistory['changes'][number]['where']; change: number; isFuller: boolean; text: string; /** 0 to 1 of half the width. */ share: number }

export const barSize = { width: 96, height: 12, half: 46 } as const;
const shownChanges = 6;

export function signedPlain(value: number): string {
  const text = plainNumber(value);
  return value > 0 ? `+${text}` : text;
}

export function cellBars({ changes, unit }: CellHistory): CellBar[] {
  const shown = changes.slice(-shownChanges);
  const largest = Math.max(...shown.map((c) => Math.abs(c.after - c.before)), 1e-12);
  return shown.map((c) => {
    const change = c.after - c.before;
    return { ping: c.ping, where: c.where, change, isFuller: fullness(unit, change) > 0, share: Math.abs(change) / largest, text: unit === 'log-odds' ? signedDecimals(change, 2) : signedPlain(change) };
  });
}
