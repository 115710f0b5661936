// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Which of the changed cells is looked at. */
import { fullness } from '../formula/fullness.ts';
import type { Stepped } from '../protocol/messages.ts';

export type Cell = Stepped['cells'][number];
export interface CellIndex { i: number; j: number }

/** How much fuller it gets; below 0: emptier. */
export const gain = (c: Cell, unit: string): number => fullness(unit, c.after - c.before);

/** The one that gets fuller most; where none does, the one that gets emptier most. */
export function firstCell(cells: readonly Cell[], unit: string): Cell | null {
  let best: Cell | null = null;
  for (const c of cells) if (!best || gain(c, unit) > gain(best, unit)) best = c;
  if (best && gain(best, unit) > 0) return best;
  best = null;
  for (const c of cells) if (!best || Math.abs(gain(c, unit)) > Math.abs(gain(best, unit))) best = c;
  return best;
}

export function chosenCell(cells: readonly Cell[], wanted: CellIndex | null, unit: string): Cell | null {
  return cells.find((c) => c.i === wanted?.i && c.j === wanted.j) ?? firstCell(cells, unit);
}

/** The n-th after this one, in rows from below; around at the end. */
export function cellAfter(cells: readonly Cell[], from: CellIndex, by: number): Cell | null {
  const rows = inRows(cells);
  const at = rows.findIndex((c) => c.i === from.i && c.j === from.j);
  return rows[(((at + by) % rows.length) + rows.length) % rows.length] ?? null;
}

export function cellRank(cells: readonly Cell[], cell: CellIndex): number {
  return inRows(cells).findIndex((c) => c.i === cell.i && c.j === cell.j) + 1;
}

const inRows = (cells: readonly Cell[]): Cell[] => [...cells].sort((a, b) => a.j - b.j || a.i - b.i);

/** Number of a ping some pings on or back, within what the log holds. */
export function pingAfter(ping: number, by: number, pings: number): number {
  return Math.max(0, Math.min(Math.max(0, pings - 1), ping + by));
}
