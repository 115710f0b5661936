// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** The view in the URL's hash. What is not understood is kept, what is not valid is ignored. */
import type { Camera, LayerName, View, ViewName } from './model.ts';

export const viewNames: readonly ViewName[] = ['map', 'compare', 'step', 'explain', 'sensor', 'options'];
export const layerNames: readonly LayerName[] = ['arcs', 'bounds', 'path', 'plan', 'truth', 'laser'];
export const scaleRange = { min: 8, max: 600 } as const;
const placeLimitM = 1e5;
const nameForm = /^[a-z0-9][a-z0-9_-]{0,63}$/i;
const listLimit = 32;

export interface UrlState {
  view: Partial<View>;
  token: string | null;
  /** Keys that are not of the view, in their order; values as they were written. */
  others: [string, string][];
}

type Reader = (value: string, view: Partial<View>) => boolean;

function numberIn(text: string | undefined, min: number, max: number): number | null {
  if (text === undefined || !/^-?\d+(\.\d+)?$/.test(text)) return null;
  const value = Number(text);
  return value >= min && value <= max ? value : null;
}

function integerIn(text: string | undefined, min: number, max: number): number | null {
  const value = numberIn(text, min, max);
  return value !== null && Number.isInteger(value) ? value : null;
}

function setIf<K extends keyof View>(view: Partial<View>, key: K, value: View[K] | null): boolean {
  if (value === null) return false;
  view[key] = value;
  return true;
}

function names(value: string): string[] | null {
  const list = value.split(',');
  return list.length <= listLimit && list.every((name) => nameForm.test(name)) ? [...new Set(list)] : null;
}

function readCamera(value: string): Camera | null {
  const parts = value.split(',');
  const x = numberIn(parts[0], -placeLimitM, placeLimitM);
  const y = numberIn(parts[1], -placeLimitM, placeLimitM);
  const s = numberIn(parts[2], scaleRange.min, scaleRange.max);
  return parts.length === 3 && x !== null && y !== null && s !== null ? { x, y, s } : null;
}

function readCell(value: string): { i: number; j: number } | null {
  const parts = value.split(',');
  const i = integerIn(parts[0], -1e7, 1e7);
  const j = integerIn(parts[1], -1e7, 1e7);
  return parts.length === 2 && i !== null && j !== null ? { i, j } : null;
}

function readExplain(value: string): View['explain'] {
  const [method, where, ...rest] = value.split(':');
  if (!method || !nameForm.test(method) || where === undefined || rest.length > 0) return null;
  if (!where.includes(',')) {
    const slot = integerIn(where, 0, 4294967295);
    return slot === null ? null : { method, slot, x: Number.NaN, y: Number.NaN };
  }
  const [x, y, ...more] = where.split(',').map((part) => numberIn(part, -placeLimitM, placeLimitM));
  return typeof x === 'number' && typeof y === 'number' && more.length === 0 ? { method, slot: null, x, y } : null;
}

function readCompare<K extends keyof View['compare']>(view: Partial<View>, key: K, value: View['compare'][K] | null): boolean {
  if (value === null) return false;
  view.compare = { ...defaultCompare, ...view.compare, [key]: value };
  return true;
}

export const defaultCompare: View['compare'] = { mode: 'side', blend: 0.5, swipe: 0.5, methods: [] };
const modes = ['side', 'swipe', 'blend'] as const;

const readers: Record<string, Reader> = {
  v: (value, view) => setIf(view, 'name', viewNames.find((name) => name === value) ?? null),
  c: (value, view) => setIf(view, 'camera', readCamera(value)),
  follow: (value, view) => setIf(view, 'follow', value === '1' ? true : value === '0' ? false : null),
  m: (value, view) => setIf(view, 'shown', names(value)),
  l: (value, view) => {
    const list = value === '' ? [] : value.split(',');
    if (!list.every((name) => layerNames.some((known) => known === name))) return false;
    return setIf(view, 'layers', new Set(list as LayerName[]));
  },
  arcs: (value, view) => setIf(view, 'arcs', /^(scan|250|s\d{1,5}|r\d{1,2})$/.test(value) ? value : null),
  cmp: (value, view) => readCompare(view, 'mode', modes.find((mode) => mode === value) ?? null),
  b: (value, view) => readCompare(view, 'blend', numberIn(value, 0, 1)),
  w: (value, view) => readCompare(view, 'swipe', numberIn(value, 0, 1)),
  cm: (value, view) => readCompare(view, 'methods', names(value)?.slice(0, 4) ?? null),
  t: (value, view) => setIf(view, 'heldAt', numberIn(value, -1e12, 1e12)),
  ping: (value, view) => setIf(view, 'ping', integerIn(value, 0, 4294967295)),
  step: (value, view) => setIf(view, 'step', integerIn(value, 1, 5)),
  cell: (value, view) => setIf(view, 'cell', readCell(value)),
  pt: (value, view) => setIf(view, 'explain', readExplain(value)),
  s: (value, view) => setIf(view, 'sensor', integerIn(value, 0, 65535)),
  of: (value, view) => setIf(view, 'optionsOf', nameForm.test(value) ? value : null),
  theme: (value, view) => setIf(view, 'theme', value === 'dark' || value === 'light' ? value : null),
};

function decoded(text: string): string | null {
  try {
    return decodeURIComponent(text);
  } catch {
    return null;
  }
}

export function parseHash(hash: string): UrlState {
  const state: UrlState = { view: {}, token: null, others: [] };
  for (const part of hash.replace(/^#/, '').split('&')) {
    if (part === '') continue;
    const at = part.indexOf('=');
    const key = decoded(at < 0 ? part : part.slice(0, at));
    const value = decoded(at < 0 ? '' : part.slice(at + 1));
    if (key === null || value === null) continue;
    if (key === 'token') state.token = /^[\w-]{1,128}$/.test(value) ? value : null;
    else if (Object.hasOwn(readers, key)) readers[key]?.(value, state.view);
    else state.others.push([key, value]);
  }
  return state;
}

const short = (value: number, digits: number): string => String(Number(value.toFixed(digits)));

function compareParts(view: View): [string, string | null][] {
  if (view.name !== 'compare') return [];
  const { mode, blend, swipe, methods } = view.compare;
  return [
    ['cmp', mode], ['b', mode === 'blend' ? short(blend, 3) : null], ['w', mode === 'swipe' ? short(swipe, 3) : null],
    ['cm', methods.length > 0 ? methods.join(',') : null],
  ];
}

function subjectParts(view: View): [string, string | null][] {
  const { explain, cell } = view;
  const where = explain?.slot ?? (explain ? `${short(explain.x, 3)},${short(explain.y, 3)}` : null);
  return [
    ['t', view.heldAt === null ? null : short(view.heldAt, 3)],
    ['ping', view.name === 'step' && view.ping !== null ? String(view.ping) : null],
    ['step', view.name === 'step' ? String(view.step) : null],
    ['cell', view.name === 'step' && cell ? `${cell.i},${cell.j}` : null],
    ['pt', view.name === 'explain' && explain ? `${explain.method}:${where}` : null],
    ['s', view.name === 'sensor' && view.sensor !== null ? String(view.sensor) : null],
    ['of', view.name === 'options' ? view.optionsOf : null],
  ];
}

const escaped = (text: string): string => encodeURIComponent(text).replace(/%2C/g, ',').replace(/%3A/g, ':');

/** The hash of a view, without its '#'; the token is never in it. */
export function writeHash(view: View, others: readonly [string, string][], themeChosen: boolean): string {
  const { camera } = view;
  const parts: [string, string | null][] = [
    ['v', view.name],
    ['c', camera ? `${short(camera.x, 3)},${short(camera.y, 3)},${short(camera.s, 2)}` : null],
    ['follow', view.follow ? '1' : null],
    ['m', view.shown.length > 0 ? view.shown.join(',') : null],
    ['l', [...view.layers].join(',')],
    ['arcs', view.arcs === 'scan' ? null : view.arcs],
    ...compareParts(view), ...subjectParts(view),
    ['theme', themeChosen ? view.theme : null],
    ...others.filter(([key]) => key !== 'token'),
  ];
  return parts.filter((part): part is [string, string] => part[1] !== null)
    .map(([key, value]) => `${escaped(key)}=${escaped(value)}`).join('&');
}
