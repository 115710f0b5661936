// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Everything the server says fits the schema, and everything the schema lets a client say is understood. */
import Ajv2020 from 'ajv/dist/2020.js';
import { readFileSync } from 'node:fs';
import { afterAll, beforeAll, expect, test } from 'vitest';
import { Client, type Message, Served } from './served.ts';

const schema = JSON.parse(readFileSync(new URL('../../../schema/messages.schema.json', import.meta.url), 'utf8')) as {
  $id: string; $defs: Record<string, { properties?: { type?: { const?: string } }; anyOf?: { $ref: string }[] }>;
};
const ajv = new Ajv2020({ strict: false });
ajv.addSchema(schema);

/** By the name of the type, so that a fault is reported for the one that was meant. */
const serverTypes = new Map((schema.$defs['FromServer']?.anyOf ?? []).map(({ $ref }) => {
  const name = $ref.split('/').at(-1) ?? '';
  return [schema.$defs[name]?.properties?.type?.const ?? '', ajv.compile({ $ref: `${schema.$id}#/$defs/${name}` })];
}));

function faults(messages: readonly Message[]): string[] {
  return messages.flatMap((message) => {
    const check = serverTypes.get(message.type);
    if (!check) return [`unknown type '${message.type}'`];
    const fits: unknown = check(message);
    return fits === true ? [] : [`${message.type}: ${ajv.errorsText(check.errors)}: ${JSON.stringify(message).slice(0, 300)}`];
  });
}

let served: Served;
beforeAll(async () => { served = await Served.start('--scene', 'demo', '--method', 'consensus,evidence,atm_mod'); }, 40_000);
afterAll(async () => { await served.stop(); }, 30_000);

test('five seconds of a session fit the schema', async () => {
  const client = await Client.open(served);
  await new Promise((resolve) => setTimeout(resolve, 5000));
  const types = new Set(client.messages.map((message) => message.type));
  for (const type of ['welcome', 'history', 'state', 'counters', 'methods', 'scores', 'timeline', 'viewers']) expect(types, type).toContain(type);
  expect(faults(client.messages)).toEqual([]);
  const kinds = new Set(client.frames.map((frame) => frame[0]));
  expect([...kinds].sort()).toEqual(expect.arrayContaining([1, 2, 3, 5]));
  client.close();
});

test('binary frames have the length that their heads announce', async () => {
  const client = await Client.open(served);
  await new Promise((resolve) => setTimeout(resolve, 2000));
  const sizes: Record<number, number> = { 1: 64, 2: 8 + 4096, 3: 44, 4: 8, 5: 8 };
  for (const frame of client.frames) {
    const size = sizes[frame[0] ?? 0];
    expect(size, `kind ${frame[0]}`).toBeDefined();
    expect(frame.length).toBe(16 + (size ?? 0) * frame.readUInt32LE(4));
  }
  client.close();
});

test('a map put together from deltas has no more than a fresh one', async () => {
  const early = await Client.open(served);
  await new Promise((resolve) => setTimeout(resolve, 3000));
  early.say({ type: 'mode', mode: 'stand' });
  const late = await Client.open(served);
  await late.until(() => late.frames.some((frame) => frame[0] === 3), 'points');
  const alive = (client: Client): Map<string, string> => {
    const points = new Map<string, string>();
    for (const frame of client.frames.filter((f) => f[0] === 3)) {
      if (frame.readUInt16LE(2) & 1) for (const key of [...points.keys()]) if (key.startsWith(`${frame[1]}:`)) points.delete(key);
      for (let i = 0; i < frame.readUInt32LE(4); i++) {
        const record = frame.subarray(16 + 44 * i, 60 + 44 * i);
        const key = `${frame[1]}:${record.readUInt32LE(0)}`;
        if ((record[39] ?? 0) & 1) points.delete(key);
        else points.set(key, record.subarray(4, 12).toString('hex'));
      }
    }
    return points;
  };
  // Both go on while they are compared: what the fresh one has and the other lacks must vanish as soon as both are up to date.
  await early.until(() => {
    const [a, b] = [alive(early), alive(late)];
    return [...b].every(([key, place]) => a.get(key) === place) && a.size === b.size;
  }, 'equal maps', 15_000);
  early.close();
  late.close();
}, 30_000);

test('questions are answered in their form', async () => {
  const client = await Client.open(served);
  await client.until(() => client.frames.some((frame) => frame[0] === 3 && frame.readUInt32LE(4) > 0), 'points');
  const frame = client.frames.find((f) => f[0] === 3 && f.readUInt32LE(4) > 0) as Buffer;
  const running = (await client.next<Message & { running: { method: string }[] }>('methods')).running;
  const method = running[frame[1] ?? 0]?.method;
  const pings = client.messages.filter((m) => m.type === 'state').at(-1)?.['pings'] as number ?? 10;
  client.say({ type: 'explain', id: 1, method, slot: frame.readUInt32LE(16) });
  client.say({ type: 'explain', id: 2, method: 'evidence', x: 1.0, y: 0.8 });
  client.say({ type: 'step', id: 3, method: 'evidence', ping: Math.max(0, pings - 5) });
  client.say({ type: 'pings', id: 4, from: 0, count: 10 });
  client.say({ type: 'snapshot', id: 5, t: 2.0, methods: ['evidence'] });
  client.say({ type: 'ping', id: 6 });
  for (const id of [1, 2, 3, 4, 5, 6])
    await client.until(() => client.messages.find((message) => message['id'] === id), `answer ${id}`);
  const answers = client.messages.filter((message) => message['id'] !== undefined && message['id'] !== null);
  expect(faults(answers)).toEqual([]);
  expect(answers.map((answer) => [answer['id'], answer.type])).toEqual(expect.arrayContaining(
    [[2, 'explanation'], [3, 'stepped'], [4, 'pings_end'], [5, 'snapshot_end'], [6, 'pong']]));
  client.close();
}, 30_000);

test('questions about what is not there are refused with cause and remedy', async () => {
  const client = await Client.open(served);
  client.say({ type: 'explain', id: 21, method: 'no_such', x: 0, y: 0 });
  client.say({ type: 'explain', id: 22, method: 'consensus', slot: 4_000_000_000 });
  client.say({ type: 'step', id: 23, method: 'evidence', ping: 4_000_000_000 });
  for (const id of [21, 22, 23]) {
    const error = await client.next<Message & { message: string; remedy: string }>('error', (m) => m['id'] === id);
    expect(error.message.length).toBeGreaterThan(10);
    expect(error.remedy.length).toBeGreaterThan(10);
  }
  client.close();
});

test('driving: rights are asked for, handed over, and lost', async () => {
  const first = await Client.open(served, { token: served.token });
  const second = await Client.open(served, { token: served.token });
  const watcher = await Client.open(served);
  first.say({ type: 'take' });
  const welcome = await first.next<Message & { you: { viewer: number; may_drive: boolean } }>('welcome');
  expect(welcome.you.may_drive).toBe(true);
  expect((await watcher.next<Message & { you: { may_drive: boolean } }>('welcome')).you.may_drive).toBe(false);
  await first.next('state', (m) => m['driver'] === welcome.you.viewer);
  second.say({ type: 'drive', v: 0.1, w: 0 });
  await second.next('error');
  second.say({ type: 'take' });
  await first.next('drive_request');
  first.say({ type: 'answer', accept: true });
  const other = await second.next<Message & { you: { viewer: number } }>('welcome');
  await second.next('state', (m) => m['driver'] === other.you.viewer);
  await first.next('drive_lost');
  for (let i = 0; i < 20; i++) {
    second.say({ type: 'drive', v: 0.1, w: 0.4, seq: i });
    await new Promise((resolve) => setTimeout(resolve, 50));
  }
  await second.next('state', (m) => (m['v'] as number) > 0.05);
  const from = watcher.mark();
  watcher.say({ type: 'stop' });
  const stopped = await watcher.next<Message & { v: number; stopped_by: { who: string } | null }>('state', (m) => m['v'] === 0 && m['stopped_by'] !== null, from);
  expect(stopped.stopped_by?.who).toBe('viewer');
  for (const client of [first, second, watcher]) {
    expect(faults(client.messages)).toEqual([]);
    client.close();
  }
}, 30_000);

test('a strategy says what it has in mind, in its form, and is silent when it ends', async () => {
  const client = await Client.open(served, { token: served.token });
  const modes = (await client.next<Message & { modes: string[] }>('welcome')).modes;
  expect(modes).toEqual(expect.arrayContaining(['frontier', 'gvg', 'wall-left', 'wall-right', 'goto', 'home', 'stand']));
  for (const mode of ['wall-left', 'frontier']) {
    const from = client.mark();
    client.say({ type: 'mode', mode });
    await client.next('state', (m) => m['mode'] === mode && m['strategy'] === mode && m['detail'] !== '', from);
    await client.next('plan', (m) => m['strategy'] === mode, from);
  }
  const late = await Client.open(served);
  await late.next('plan', (m) => m['strategy'] === 'frontier');
  const from = client.mark();
  client.say({ type: 'stop' });
  const none = await client.next<Message & { nodes: unknown[]; path: unknown[] }>('plan', (m) => m['strategy'] === '', from);
  expect([none.nodes, none.path]).toEqual([[], []]);
  expect(faults([...client.messages, ...late.messages])).toEqual([]);
  late.close();
  client.close();
}, 30_000);

test('options are recomputed from the log, and refused out of range', async () => {
  const client = await Client.open(served, { token: served.token });
  client.say({ type: 'options', method: 'evidence', options: { occupied_peak: 0.9 } });
  await client.next<Message & { running: { method: string; state: string; options: Record<string, number> }[] }>(
    'methods', (m) => m.running.some((r) => r.method === 'evidence' && r.options['occupied_peak'] === 0.9 && r.state === 'ok'));
  const from = client.mark();
  client.say({ type: 'options', method: 'evidence', options: { occupied_peak: 7 } });
  expect((await client.next<Message & { message: string }>('error', () => true, from)).message).toContain('occupied_peak');
  client.say({ type: 'method_add', method: 'centerline' });
  await client.next<Message & { running: { method: string }[] }>('methods', (m) => m.running.some((r) => r.method === 'centerline'), from);
  client.say({ type: 'method_remove', method: 'centerline' });
  await client.next<Message & { running: { method: string }[] }>('methods', (m) => m.running.every((r) => r.method !== 'centerline'), client.mark());
  expect(faults(client.messages)).toEqual([]);
  client.close();
}, 30_000);

test('one method runs twice, each under its id', async () => {
  const client = await Client.open(served, { token: served.token });
  client.say({ type: 'method_add', method: 'evidence-2', name: 'evidence', options: { occupied_peak: 0.7 } });
  type Told = Message & { running: { method: string; name: string; label: string; options: Record<string, number> }[] };
  const told = await client.next<Told>('methods', (m) => m.running.some((r) => r.method === 'evidence-2'));
  const of = (id: string): Told['running'][number] | undefined => told.running.find((r) => r.method === id);
  expect([of('evidence')?.name, of('evidence-2')?.name]).toEqual(['evidence', 'evidence']);
  expect(of('evidence')?.label).not.toBe(of('evidence-2')?.label);
  expect(of('evidence-2')?.options['occupied_peak']).toBe(0.7);
  client.say({ type: 'method_add', method: 'consensus', name: 'evidence' });
  await client.next('error');
  const place = told.running.findIndex((r) => r.method === 'evidence-2');
  await client.until(() => client.frames.some((f) => f[0] === 2 && f[1] === place && f.readUInt32LE(4) > 0), 'its tiles');
  client.say({ type: 'snapshot', id: 31, t: 1e9, methods: ['consensus', 'evidence-2'] });
  await client.until(() => client.messages.find((m) => m['id'] === 31), 'the snapshot');
  const kinds = new Set(client.frames.filter((f) => f.readUInt32LE(12) === 31 && f.readUInt32LE(4) > 0).map((f) => `${f[1]}:${f[0]}`));
  expect(kinds).toEqual(new Set(['0:3', '1:2']));
  const picture = await fetch(`${served.origin}/api/map/evidence-2.png`);
  expect([picture.status, picture.headers.get('content-type')]).toEqual([200, 'image/png']);
  client.say({ type: 'method_remove', method: 'evidence-2' });
  await client.next<Told>('methods', (m) => m.running.every((r) => r.method !== 'evidence-2'), client.mark());
  expect((await fetch(`${served.origin}/api/map/evidence-2.png`)).status).toBe(404);
  expect(faults(client.messages)).toEqual([]);
  client.close();
}, 30_000);

test('a log that is sent is called by its name, and by nothing of its path', async () => {
  const log = await (await fetch(`${served.origin}/api/log`)).text();
  const answer = await fetch(`${served.origin}/api/log`, {
    method: 'POST', body: log, headers: { Authorization: `Bearer ${served.token}`, 'X-File-Name': encodeURIComponent('../../a/Büro 2.jsonl') },
  });
  expect(answer.status).toBe(200);
  const { room } = (await answer.json()) as { room: string };
  const client = await Client.open(served, { room });
  const welcome = await client.next<Message & { source: { title: string; kind: string }; robot: { sensors: { rate_hz: number | null }[] } }>('welcome');
  expect([welcome.source.title, welcome.source.kind]).toEqual(['Büro 2.jsonl', 'log']);
  expect(welcome.robot.sensors[0]?.rate_hz).toBeNull();
  client.close();
}, 30_000);
