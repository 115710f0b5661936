// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

const firstS = 0.5;
const lastS = 5;
const jitter = 0.2;

/** Wait before the n-th attempt (from 1): 0.5 s doubling up to 5 s, scattered so that many pages do not return at once. */
export function backoffMs(attempt: number, random: () => number = Math.random): number {
  const seconds = Math.min(lastS, firstS * 2 ** Math.max(0, attempt - 1));
  return 1000 * seconds * (1 + jitter * (2 * random() - 1));
}
