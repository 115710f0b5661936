// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Which mark and colour a method of points has: a slot of four, the same in every part of the page. */
import type { Methods } from '../protocol/messages.ts';
import type { ColourName } from './palette.ts';

export type MarkSlot = 1 | 2 | 3 | 4;
export const slotColour: Record<MarkSlot, ColourName> = { 1: 'atm', 2: 'carve', 3: 'center', 4: 'none' };
const all: readonly MarkSlot[] = [1, 2, 3, 4];

/** `order`: methods in the order in which they were switched on; those beyond the fourth share the last slot. */
export function markSlots(methods: Methods | null, order: readonly string[]): Map<string, MarkSlot> {
  const points = (methods?.running ?? []).filter((r) => r.points).map((r) => r.method);
  const fixed: Record<string, MarkSlot> = { [points.includes('consensus') ? 'consensus' : 'atm']: 1, carve: 2, centerline: 3 };
  const slots = new Map<string, MarkSlot>();
  for (const method of points) {
    const slot = fixed[method];
    if (slot !== undefined) slots.set(method, slot);
  }
  const rank = (method: string): number => { const i = order.indexOf(method); return i < 0 ? order.length : i; };
  const others = points.filter((method) => !slots.has(method)).sort((a, b) => rank(a) - rank(b));
  const used = new Set(slots.values());
  for (const method of others) {
    const free = all.find((slot) => !used.has(slot)) ?? 4;
    used.add(free);
    slots.set(method, free);
  }
  return slots;
}
