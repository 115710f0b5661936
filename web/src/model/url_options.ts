// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Changed options in the URL, as `o.METHOD.OPTION=value`: they are the room's, not the page's, so they are offered, never applied unasked. */
import type { Method, MethodAdd, Methods, Option, Options, OptionValues } from '../protocol/messages.ts';
import { runningOf } from './instances.ts';

type Value = OptionValues[string];
export type OptionWish = MethodAdd | Options;
export const isOptionKey = (key: string): boolean => key.startsWith('o.');

function valueOf(option: Option, text: string): Value | null {
  if (option.kind === 'boolean') return text === 'true' ? true : text === 'false' ? false : null;
  if (option.kind === 'choice') return option.choices.includes(text) ? text : null;
  if (!/^-?\d+(\.\d+)?(e-?\d+)?$/i.test(text)) return null;
  const value = Number(text);
  const fits = (option.min === null || value >= option.min) && (option.max === null || value <= option.max);
  return fits && (option.kind === 'real' || Number.isInteger(value)) ? value : null;
}

/** The method of the catalogue that an id is of, also when it does not run: `numakura-test-1` is Numakura. */
function methodOf(id: string, methods: Methods, catalogue: readonly Method[]): Method | undefined {
  const name = runningOf(methods, id)?.name;
  if (name !== undefined) return catalogue.find((m) => m.name === name);
  const own = catalogue.filter((m) => id === m.name || id.startsWith(`${m.name}-`));
  return own.sort((a, b) => b.name.length - a.name.length)[0];
}

function changedOf(method: Method, values: OptionValues): OptionValues {
  return Object.fromEntries(method.options.flatMap((o) => {
    const value = values[o.name];
    return value === undefined || value === o.default ? [] : [[o.name, value]];
  }));
}

/** What must be sent so that the room's methods are as the URL says; what it cannot mean is left out. */
export function optionWishes(keys: readonly (readonly [string, string])[], methods: Methods, catalogue: readonly Method[]): OptionWish[] {
  const wished = new Map<string, { method: Method; options: OptionValues }>();
  for (const [key, text] of keys) {
    const [, id, name, ...rest] = key.split('.');
    if (!isOptionKey(key) || id === undefined || rest.length > 0) continue;
    const method = methodOf(id, methods, catalogue);
    const option = method?.options.find((o) => o.name === name);
    const value = option ? valueOf(option, text) : null;
    if (!method || !option || value === null) continue;
    const wish = wished.get(id) ?? { method, options: {} };
    wish.options[option.name] = value;
    wished.set(id, wish);
  }
  return [...wished].flatMap(([id, { method, options }]): OptionWish[] => {
    const running = runningOf(methods, id);
    if (!running) return [{ type: 'method_add', method: id, ...(id === method.name ? {} : { name: method.name }), options: changedOf(method, options) }];
    if (Object.entries(options).every(([name, value]) => running.options[name] === value)) return [];
    return [{ type: 'options', method: id, options: changedOf(method, { ...running.options, ...options }) }];
  });
}

/** Keys for a link that tell the changed options of the methods that are seen. */
export function optionKeys(seen: readonly string[], methods: Methods | null, catalogue: readonly Method[]): [string, string][] {
  return [...new Set(seen)].flatMap((id) => {
    const running = runningOf(methods, id);
    const method = catalogue.find((m) => m.name === running?.name);
    return running && method ? Object.entries(changedOf(method, running.options)).map(([name, value]): [string, string] => [`o.${id}.${name}`, String(value)]) : [];
  });
}
