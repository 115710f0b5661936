// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

import { expect, test } from 'vitest';
import { defaultView } from '../../src/model/defaults.ts';
import type { View } from '../../src/model/model.ts';
import { parseHash, writeHash } from '../../src/model/url_state.ts';

const view = (change: Partial<View>): View => ({ ...defaultView(false), ...change });

test.each<Partial<View>>([
  { name: 'map', camera: { x: -1.25, y: 3, s: 120.5 }, follow: true, shown: ['atm', 'evidence'], layers: new Set(['arcs', 'truth']), arcs: 's3' },
  { name: 'compare', compare: { mode: 'blend', blend: 0.25, swipe: 0.5, methods: ['atm', 'centerline'] } },
  { name: 'compare', compare: { mode: 'swipe', blend: 0.5, swipe: 0.4, methods: [] } },
  { name: 'step', ping: 2163, step: 4, cell: { i: -3, j: 20 }, heldAt: 86.52 },
  { name: 'explain', explain: { method: 'evidence', slot: null, x: 1.5, y: -2 } },
  { name: 'sensor', sensor: 3 },
  { name: 'options', optionsOf: 'carve', layers: new Set() },
])('what is written is read again: $name', (change) => {
  const before = view(change);
  const read = parseHash(writeHash(before, [], false));
  expect({ ...defaultView(false), ...read.view }).toEqual(before);
  expect(read.others).toEqual([]);
});

test('a point is told by its slot', () => {
  const hash = writeHash(view({ name: 'explain', explain: { method: 'atm', slot: 17, x: 1, y: 2 } }), [], false);
  expect(hash).toContain('pt=atm:17');
  expect(parseHash(hash).view.explain).toMatchObject({ method: 'atm', slot: 17 });
});

test('what is not known is kept in its order, and nothing is made of it', () => {
  const others = parseHash('#v=map&o.carve.guard=0.025&src=scene:rooms&__proto__=1&constructor=x&new%26key=a%3Db').others;
  expect(others).toEqual([['o.carve.guard', '0.025'], ['src', 'scene:rooms'], ['__proto__', '1'], ['constructor', 'x'], ['new&key', 'a=b']]);
  expect(parseHash(writeHash(view({}), others, false)).others).toEqual(others);
});

test.each([
  'v=nonsense', 'c=1,2', 'c=1,2,0', 'c=1,2,1e9', 'c=NaN,0,50', 'c=Infinity,0,50', 'c=1,2,50,7', 'c=0x10,0,50', 'm=<script>', 'm=' + 'a,'.repeat(500), 'm=../..',
  'l=arcs,magic', 'arcs=s', 'arcs=250x', 'b=2', 'b=-0.1', 't=', 't=abc', 'ping=-1', 'ping=4294967296', 'ping=1.5', 'step=0', 'step=6', 'cell=1', 'cell=a,b',
  'pt=atm', 'pt=:3', 'pt=atm:1:2', 'pt=atm:x,y', 's=70000', 'theme=purple', 'follow=yes', 'of=%00', 'v=%E0%A4%A', '%', '&&&=', '=',
])('a value that is not valid is ignored: %s', (hash) => {
  expect(parseHash(`#${hash}`).view).toEqual({});
});

test('the token is read once and never written', () => {
  expect(parseHash('#token=abc_-9&v=map').token).toBe('abc_-9');
  expect(parseHash('#token=a b').token).toBeNull();
  expect(parseHash(`#token=${'a'.repeat(200)}`).token).toBeNull();
  expect(writeHash(view({}), [['token', 'secret']], true)).not.toContain('secret');
});

test('the theme is written only when it was chosen', () => {
  expect(writeHash(view({ theme: 'dark' }), [], false)).not.toContain('theme');
  expect(writeHash(view({ theme: 'dark' }), [], true)).toContain('theme=dark');
});
