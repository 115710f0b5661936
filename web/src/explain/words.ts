// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Every text of the answer to "why is this here". */
import { unitWords } from '../formula/fullness.ts';
import { count, decimals, signedDecimals } from '../formula/numbers.ts';

export type CellState = 'occupied' | 'free' | 'unknown';

export function cellState(probability: number | null): CellState {
  if (probability === null || probability === 0.5) return 'unknown';
  return probability > 0.5 ? 'occupied' : 'free';
}

const pings = (n: number): string => `${count(n)} ${n === 1 ? 'ping' : 'pings'}`;

export const words = {
  whyPoint: 'Why is this point here?',
  whyCell: (state: CellState): string => `Why is this cell ${state}?`,
  whySomething: 'Why is this here?',
  lookingThrough: (n: number): string => `Looking through ${pings(n)}`,
  looking: 'Looking for the pings behind it',
  nothingChosen: 'Click a point on the map, or a cell from zoom 90, to see the pings behind it.',
  askAgain: 'Ask again',
  explainsLive: (shown: string): string => `This explains the live map, not the moment ${shown} that is shown.`,
  backToLive: 'Back to live',
  place: 'x, y in m',
  bound: 'bound',
  noBound: 'no bound',
  offWall: 'off true wall',
  sure: 'sure',
  occupied: 'occupied',
  value: (unit: string): string => (unit === '' || unit === 'p' ? 'value' : unitWords(unit)),
  alongArc: (ping: number): string => `Along the arc of ping ${count(ping)}`,
  axis: 'beam axis',
  crossingsUsed: (n: number): string => `${count(n)} ${n === 1 ? 'crossing' : 'crossings'} used`,
  cutsUsed: (n: number): string => `${count(n)} ${n === 1 ? 'ping' : 'pings'} cut its arc`,
  arcsUsed: (n: number): string => `${pings(n)} behind it`,
  columns: { ping: 'Ping', sensor: 'Sensor', range: 'Range', bearing: 'Bearing', angle: 'Angle', did: 'What it did', says: 'What it says' },
  columnTitles: { bearing: 'Where it speaks, seen from the axis of the arc', angle: 'Angle at which the arcs cross' },
  inBold: (note: string): string => `Bold: ${note}.`,
  unused: (n: number, reason: string): string => `${pings(n)}, ${reason}`,
  notUsed: 'Not used',
  cellUnder: 'Grid cell under it',
  cellChanges: 'What the pings said about it',
  where: { on: 'on the arc', before: 'before the arc', beside: 'beside the beam' },
  cellAtP: (state: CellState, p: number | null): string => (p === null ? state : `${state}, p = ${decimals(p, 2)}`),
  latest: (shown: number, total: number): string =>
    (shown >= total ? `${total === 1 ? 'The one ping' : `All ${pings(total)}`} that changed it` : `Latest ${count(shown)} of ${pings(total)} that changed it`),
  sum: (value: number): string => `; sum ${signedDecimals(value, 2)}`,
  holds: (value: string): string => `; it holds ${value}`,
  nothingChanged: 'No ping has changed it.',
  stepThrough: (ping: number): string => `Step through ping ${count(ping)}`,
  copyLink: 'Copy link',
  linkCopied: 'Link copied',
  linkNotCopied: 'The browser did not let the link be copied.',
  barOf: (ping: number, change: string): string => `Ping ${count(ping)} changed it by ${change}`,
};

/** What the place of a point on its arc is to its method. */
export function markWord(method: string): string {
  if (method.startsWith('atm') || method === 'combined') return 'median';
  if (method === 'carve' || method === 'centerline') return 'middle';
  return method === 'consensus' ? 'likeliest' : 'point';
}
