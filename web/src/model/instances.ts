// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** One method of the catalogue may run several times, with different options under different ids. */
import type { Method, MethodAdd, Methods, OptionValues } from '../protocol/messages.ts';

export type Running = Methods['running'][number];

export function runningOf(methods: Methods | null, id: string | null | undefined): Running | undefined {
  return methods?.running.find((r) => r.method === id);
}

/** `wanted`, or the first of `wanted-2`, `wanted-3`, ... that nobody has. */
export function freeId(running: readonly Running[], wanted: string): string {
  const taken = new Set(running.map((r) => r.method));
  let id = wanted;
  for (let n = 2; taken.has(id); n++) id = `${wanted}-${n}`;
  return id;
}

/** The instance of a method that runs with these options, and defaults for the rest. */
export function instanceWith(running: readonly Running[], method: Method, changed: OptionValues): Running | undefined {
  const wanted = new Map(method.options.map((o) => [o.name, changed[o.name] ?? o.default]));
  return running.find((r) => r.name === method.name && r.state !== 'failed' && [...wanted].every(([name, value]) => (r.options[name] ?? value) === value));
}

/** Ids of maps to be seen together, and what must be added for it. */
export interface Gathering { ids: string[]; missing: MethodAdd[] }

export function gather(running: readonly Running[], method: Method, wishes: readonly { suffix: string; options: OptionValues }[]): Gathering {
  const gathering: Gathering = { ids: [], missing: [] };
  for (const { suffix, options } of wishes) {
    const there = instanceWith(running, method, options);
    const id = there?.method ?? freeId(running, `${method.name}-${suffix}`);
    gathering.ids.push(id);
    if (!there) gathering.missing.push({ type: 'method_add', method: id, name: method.name, options });
  }
  return gathering;
}

/** Numakura's four maps: how each of the outlier tests changes it. */
const outlierTests = [
  { suffix: 'no-test', options: { geometry_test: false, consistency_test: false } },
  { suffix: 'test-1', options: { geometry_test: true, consistency_test: false } },
  { suffix: 'test-2', options: { geometry_test: false, consistency_test: true } },
  { suffix: 'both-tests', options: { geometry_test: true, consistency_test: true } },
];

/** Null: this server has no Numakura. */
export function outliersGathering(methods: Methods | null, catalogue: readonly Method[]): Gathering | null {
  const numakura = catalogue.find((m) => m.name === 'numakura');
  return numakura ? gather(methods?.running ?? [], numakura, outlierTests) : null;
}

/** A running method beside the same with its defaults. */
export function defaultGathering(methods: Methods | null, method: Method, id: string): Gathering {
  const { ids, missing } = gather(methods?.running ?? [], method, [{ suffix: 'default', options: {} }]);
  return { ids: [id, ...ids], missing };
}
