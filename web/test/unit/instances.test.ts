// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

import { expect, test } from 'vitest';
import { defaultGathering, freeId, gather, instanceWith, outliersGathering, type Running } from '../../src/model/instances.ts';
import { optionKeys, optionWishes } from '../../src/model/url_options.ts';
import { Receiver } from '../../src/net/receiver.ts';
import { Questions } from '../../src/net/questions.ts';
import { Live } from '../../src/model/live.ts';
import type { FromClient, Method, Methods, Option } from '../../src/protocol/messages.ts';

const option = (name: string, kind: Option['kind'], value: Option['default'], more: Partial<Option> = {}): Option => ({
  name, kind, unit: '', default: value, min: null, max: null, choices: [], doc: '', source: '', ...more,
});
const method = (name: string, options: Option[]): Method => ({ name, title: name, short: name, summary: '', source: '', look: '', options });
const numakura = method('numakura', [option('geometry_test', 'boolean', true), option('consistency_test', 'boolean', true), option('jump_m', 'real', 0.3, { min: 0, max: 1000 })]);
const carve = method('carve', [option('guard_m', 'real', 0.025, { min: 0, max: 0.05 }), option('ring', 'integer', 250, { min: 1, max: 5000 }), option('policy', 'choice', 'bisector', { choices: ['bisector', 'both'] })]);
const catalogue = [carve, numakura];

const run = (id: string, of: Method, changed: Record<string, boolean | number | string> = {}): Running => ({
  method: id, name: of.name, label: id, state: 'ok', reason: '', grid: null, points: false, options: { ...Object.fromEntries(of.options.map((o) => [o.name, o.default])), ...changed },
});
const running = (...all: Running[]): Methods => ({ type: 'methods', running: all });

test('a free id is the wanted one, or the next of its numbers', () => {
  expect(freeId([], 'carve')).toBe('carve');
  expect(freeId([run('carve', carve), run('carve-2', carve)], 'carve')).toBe('carve-3');
});

test('an instance is known by all its options', () => {
  const all = [run('a', numakura, { jump_m: 1 }), run('b', numakura, { geometry_test: false }), run('c', carve)];
  expect(instanceWith(all, numakura, { geometry_test: false })?.method).toBe('b');
  expect(instanceWith(all, numakura, {})).toBeUndefined();
  expect(instanceWith(all, carve, {})?.method).toBe('c');
  expect(instanceWith([{ ...run('c', carve), state: 'failed' }], carve, {})).toBeUndefined();
});

test('the four maps of the outlier tests: those that run are taken, the others added', () => {
  const fresh = outliersGathering(running(), catalogue);
  expect(fresh?.ids).toEqual(['numakura-no-test', 'numakura-test-1', 'numakura-test-2', 'numakura-both-tests']);
  expect(fresh?.missing.map((m) => m.options)).toEqual([
    { geometry_test: false, consistency_test: false }, { geometry_test: true, consistency_test: false },
    { geometry_test: false, consistency_test: true }, { geometry_test: true, consistency_test: true },
  ]);
  const again = outliersGathering(running(...(fresh?.missing ?? []).map((m) => run(m.method, numakura, m.options))), catalogue);
  expect([again?.ids, again?.missing]).toEqual([fresh?.ids, []]);
  const some = outliersGathering(running(run('numakura', numakura), run('numakura-test-1', numakura, { jump_m: 2 })), catalogue);
  expect(some?.ids).toEqual(['numakura-no-test', 'numakura-test-1-2', 'numakura-test-2', 'numakura']);
  expect(some?.missing).toHaveLength(3);
  expect(outliersGathering(running(), [carve])).toBeNull();
});

test('a changed method is laid beside its defaults', () => {
  expect(defaultGathering(running(run('carve', carve, { guard_m: 0.05 })), carve, 'carve')).toEqual({
    ids: ['carve', 'carve-default'], missing: [{ type: 'method_add', method: 'carve-default', name: 'carve', options: {} }],
  });
  expect(defaultGathering(running(run('mine', carve, { guard_m: 0.05 }), run('carve', carve)), carve, 'mine')).toEqual({ ids: ['mine', 'carve'], missing: [] });
  expect(gather([], carve, [])).toEqual({ ids: [], missing: [] });
});

test('options of the URL become wishes; what they cannot mean is left out', () => {
  const methods = running(run('carve', carve, { ring: 100 }));
  expect(optionWishes([['o.carve.guard_m', '0.05']], methods, catalogue)).toEqual([{ type: 'options', method: 'carve', options: { ring: 100, guard_m: 0.05 } }]);
  expect(optionWishes([['o.carve.ring', '100']], methods, catalogue)).toEqual([]);
  expect(optionWishes([['o.carve.ring', '250']], methods, catalogue)).toEqual([{ type: 'options', method: 'carve', options: {} }]);
  expect(optionWishes([['o.numakura-test-1.consistency_test', 'false'], ['o.numakura.jump_m', '2']], methods, catalogue)).toEqual([
    { type: 'method_add', method: 'numakura-test-1', name: 'numakura', options: { consistency_test: false } },
    { type: 'method_add', method: 'numakura', options: { jump_m: 2 } },
  ]);
  for (const [key, text] of [
    ['o.carve.guard_m', '0.06'], ['o.carve.guard_m', 'NaN'], ['o.carve.guard_m', ''], ['o.carve.ring', '1.5'], ['o.carve.ring', '0x10'], ['o.carve.policy', 'none'],
    ['o.carve.nothing', '1'], ['o.nobody.guard_m', '0.01'], ['o.carve', '1'], ['o.carve.guard_m.x', '0.01'], ['o.', '1'], ['carve.guard_m', '0.01'], ['o.numakura.geometry_test', '1'],
  ] as const) expect(optionWishes([[key, text]], methods, catalogue), `${key}=${text}`).toEqual([]);
});

test('a link tells the changed options of what is seen, and they come back', () => {
  const methods = running(run('carve', carve, { guard_m: 0.05, policy: 'both' }), run('numakura-test-1', numakura, { consistency_test: false }), run('vain', carve, { ring: 9 }));
  const keys = optionKeys(['carve', 'numakura-test-1', 'carve', 'gone'], methods, catalogue);
  expect(keys).toEqual([['o.carve.guard_m', '0.05'], ['o.carve.policy', 'both'], ['o.numakura-test-1.consistency_test', 'false']]);
  expect(optionWishes(keys, methods, catalogue)).toEqual([]);
  expect(optionWishes(keys, running(run('carve', carve)), catalogue)).toEqual([
    { type: 'options', method: 'carve', options: { guard_m: 0.05, policy: 'both' } },
    { type: 'method_add', method: 'numakura-test-1', name: 'numakura', options: { consistency_test: false } },
  ]);
});

/** One point, as a frame of an answer. */
function pointFrame(question: number, method: number): ArrayBuffer {
  const view = new DataView(new ArrayBuffer(16 + 44));
  view.setUint8(0, 3);
  view.setUint8(1, method);
  view.setUint32(4, 1, true);
  view.setUint32(12, question, true);
  return view.buffer;
}

test('frames of an answer are of the methods that the question named, whatever runs by then', async () => {
  const sent: FromClient[] = [];
  const questions = new Questions((message) => { sent.push(message); return true; });
  const live = new Live({} as never);
  const receiver = new Receiver(live, () => undefined, (id) => questions.methodsOf(id));
  receiver.message(running(run('carve', carve), run('b', numakura)));
  const answer = questions.ask({ type: 'snapshot', t: 1, methods: ['b', 'carve'] }, 1000);
  const id = (sent[0] as { id: number }).id;
  receiver.message(running(run('new', carve), run('carve', carve)));
  receiver.frame(pointFrame(id, 0));
  receiver.frame(pointFrame(id, 1));
  receiver.frame(pointFrame(id, 2));
  receiver.frame(pointFrame(id + 1, 0));
  expect([...(live.answers.get(id)?.maps.keys() ?? [])]).toEqual(['b', 'carve']);
  expect(live.answers.get(id)?.maps.get('carve')?.points).toBe(1);
  expect(live.answers.get(id + 1)?.maps.size ?? 0).toBe(0);
  questions.answer({ type: 'snapshot_end', id, t: 1, pings: 3, pose: null });
  await answer;
  expect(questions.methodsOf(id)).toEqual([]);
});
