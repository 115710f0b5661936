// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

import type { ScaleBar } from './map_view.ts';

const lengthsM = [0.1, 0.2, 0.5, 1, 2, 5, 10] as const;
const leastPx = 60;

/** The first of the round lengths that is at least 60 px long. */
export function scaleBar(s: number): ScaleBar {
  const lengthM = lengthsM.find((length) => length * s >= leastPx) ?? 10;
  return { lengthM, lengthPx: lengthM * s, label: lengthM < 1 ? `${Math.round(100 * lengthM)} cm` : `${lengthM} m` };
}

/** Distance of the crosses on the ground, in metres. */
export function crossStep(s: number): number {
  if (s < 18) return 5;
  if (s < 34) return 2;
  return s < 340 ? 1 : 0.1;
}
