// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { backoffMs } from '../../src/net/backoff.ts';
import { Connection, type Hearer } from '../../src/net/connection.ts';
import { Questions } from '../../src/net/questions.ts';
import type { FromClient, FromServer } from '../../src/protocol/messages.ts';

class FakeSocket {
  static readonly OPEN = 1;
  static made: FakeSocket[] = [];
  readyState = 0;
  sent: FromClient[] = [];
  onopen: (() => void) | null = null;
  onmessage: ((event: { data: unknown }) => void) | null = null;
  onclose: ((event: { code: number }) => void) | null = null;
  constructor(readonly url: string, readonly protocol: string) { FakeSocket.made.push(this); }
  send(text: string): void { this.sent.push(JSON.parse(text) as FromClient); }
  close(): void { this.readyState = 3; }
  open(): void { this.readyState = 1; this.onopen?.(); }
  say(message: unknown): void { this.onmessage?.({ data: JSON.stringify(message) }); }
  end(code: number): void { this.readyState = 3; this.onclose?.({ code }); }
}

const last = (): FakeSocket => FakeSocket.made.at(-1) as FakeSocket;

function connect(): { connection: Connection; heard: FromServer[] } {
  const heard: FromServer[] = [];
  let id = 0;
  const hearer: Hearer = {
    hello: () => ({ type: 'hello', protocol: 1 }), message: (m) => heard.push(m), frame: () => {}, changed: () => {}, broken: () => {}, nextId: () => ++id,
  };
  const connection = new Connection('ws://here/ws', hearer);
  connection.start();
  return { connection, heard };
}

beforeEach(() => {
  vi.useFakeTimers();
  vi.stubGlobal('WebSocket', FakeSocket);
  FakeSocket.made = [];
});
afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

test('waits double from 0.5 s to 5 s, scattered by a fifth', () => {
  expect([1, 2, 3, 4, 5, 20].map((n) => backoffMs(n, () => 0.5))).toEqual([500, 1000, 2000, 4000, 5000, 5000]);
  expect([backoffMs(1, () => 0), backoffMs(1, () => 1)]).toEqual([400, 600]);
});

test('says hello, is live after the welcome, measures the round trip', () => {
  const { connection } = connect();
  expect(last().protocol).toBe('echoarc.v1');
  last().open();
  expect(last().sent).toEqual([{ type: 'hello', protocol: 1 }]);
  expect(connection.state.phase).toBe('connecting');
  last().say({ type: 'welcome' });
  expect(connection.state.phase).toBe('live');
  vi.advanceTimersByTime(12);
  last().say({ type: 'pong', id: 1, mono_us: 0 });
  expect(connection.state.roundTripMs).toBeCloseTo(12, 0);
  connection.close();
});

test('stop is not kept for later', () => {
  const { connection } = connect();
  expect(connection.send({ type: 'stop' })).toBe(false);
  last().open();
  expect(last().sent.some((m) => m.type === 'stop')).toBe(false);
  expect(connection.send({ type: 'stop' })).toBe(true);
  connection.close();
});

test('a broken connection is tried again; retryNow does not wait', () => {
  const { connection } = connect();
  last().open();
  last().say({ type: 'welcome' });
  last().end(1006);
  expect(connection.state.phase).toBe('lost');
  expect(connection.state.retryAtMs).toBeGreaterThan(performance.now());
  expect(FakeSocket.made.length).toBe(1);
  vi.advanceTimersByTime(700);
  expect(FakeSocket.made.length).toBe(2);
  last().end(1006);
  connection.retryNow();
  expect(FakeSocket.made.length).toBe(3);
  vi.advanceTimersByTime(2000);
  expect(FakeSocket.made.length).toBe(3);
  connection.close();
});

test('a viewer dropped for being slow does not return by itself', () => {
  const { connection } = connect();
  last().open();
  last().say({ type: 'welcome' });
  last().end(4008);
  expect([connection.state.phase, connection.state.reason]).toEqual(['ended', 'slow']);
  vi.advanceTimersByTime(60_000);
  expect(FakeSocket.made.length).toBe(1);
  connection.retryNow();
  expect([FakeSocket.made.length, connection.state.phase, connection.state.reason]).toEqual([2, 'lost', '']);
  connection.close();
});

test('a silent connection is taken for dead', () => {
  const { connection } = connect();
  last().open();
  last().say({ type: 'welcome' });
  vi.advanceTimersByTime(7000);
  expect(FakeSocket.made.length).toBeGreaterThan(1);
  connection.close();
});

test('answers reach who asked; refusals, time-outs and breaks reject', async () => {
  const sent: FromClient[] = [];
  const questions = new Questions((m) => { sent.push(m); return true; });
  const first = questions.ask<{ t: number }>({ type: 'snapshot', t: 3, methods: [] }, 1000);
  const second = questions.ask({ type: 'step', method: 'atm', ping: 1 }, 1000);
  const third = questions.ask({ type: 'pings', from: 0, count: 1 }, 1000);
  const fourth = questions.ask({ type: 'pings', from: 0, count: 1 }, 60_000);
  expect(questions.answer({ type: 'snapshot_end', id: 1, t: 3, pings: 2, pose: null })).toBe(true);
  expect(questions.answer({ type: 'error', id: 2, code: 'x', message: 'No such ping.', remedy: '' })).toBe(true);
  expect(questions.answer({ type: 'pings_end', id: 99 })).toBe(false);
  await expect(first).resolves.toMatchObject({ t: 3 });
  await expect(second).rejects.toMatchObject({ message: 'No such ping.' });
  vi.advanceTimersByTime(1100);
  await expect(third).rejects.toMatchObject({ code: 'timeout' });
  questions.abandon();
  await expect(fourth).rejects.toMatchObject({ code: 'not_connected' });
  await expect(new Questions(() => false).ask({ type: 'step', method: 'a', ping: 0 }, 10)).rejects.toMatchObject({ code: 'not_connected' });
});
