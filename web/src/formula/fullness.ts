// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** What a change of a cell's number means: of most methods more is fuller, evidence counts for free space. */
export function fullness(unit: string, change: number): number {
  return unit === 'evidence' ? -change : change;
}

/** A unit in words. */
export const unitWords = (unit: string): string => (unit === 'evidence' ? 'evidence for free' : unit);
