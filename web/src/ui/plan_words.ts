// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** What a plan holds, in words: for the list of layers, and for who does not see the map. */
import type { Plan } from '../protocol/messages.ts';
import { fixed, whole } from './format.ts';

const kinds: readonly [string, string, string][] = [
  ['frontier', 'frontier', 'frontiers'], ['meet', 'meet point', 'meet points'], ['boundary', 'dead end', 'dead ends'],
];

export function lengthOf(path: readonly (readonly [number, number])[]): number {
  return path.slice(1).reduce((sum, [x, y], i) => sum + Math.hypot(x - (path[i]?.[0] ?? x), y - (path[i]?.[1] ?? y)), 0);
}

export function planInWords(plan: Plan | null): string {
  if (!plan) return 'nothing planned';
  const parts = kinds.flatMap(([kind, one, many]) => {
    const count = plan.nodes.filter((node) => node.kind === kind).length;
    return count > 0 ? [`${whole(count)} ${count === 1 ? one : many}`] : [];
  });
  const ahead = lengthOf(plan.path);
  if (ahead > 0) parts.push(`${fixed(ahead, 1)} m ahead`);
  return parts.length > 0 ? parts.join(', ') : 'no way planned';
}
