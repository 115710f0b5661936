// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Hostile clients: refused, counted, and nobody else notices. */
import { once } from 'node:events';
import { request } from 'node:http';
import { connect, type Socket } from 'node:net';
import { afterAll, beforeAll, expect, test } from 'vitest';
import WebSocket from 'ws';
import { Client, longestPause, Served } from './served.ts';

const pauseLimitMs = 400; // states come every 100 ms; the rest is what a busy machine may add

let served: Served;
let bystander: Client;
beforeAll(async () => {
  served = await Served.start('--scene', 'demo');
  bystander = await Client.open(served);
}, 40_000);
afterAll(async () => {
  bystander.close();
  await served.stop();
}, 30_000);

async function raw(): Promise<Socket> {
  const socket = connect(served.port, '127.0.0.1');
  socket.on('error', () => {});
  await once(socket, 'connect');
  return socket;
}

/** Everything until the server closes, or `ms` passed. */
async function drain(socket: Socket, ms: number): Promise<{ text: string; closed: boolean }> {
  let text = '';
  socket.on('data', (piece: Buffer) => { text += piece.toString('latin1'); });
  const closed = await Promise.race([once(socket, 'close').then(() => true), new Promise<boolean>((r) => setTimeout(() => r(false), ms))]);
  return { text, closed };
}

async function get(path: string, headers: Record<string, string> = {}, method = 'GET', body = ''): Promise<{ status: number; text: string; headers: Record<string, string | string[] | undefined> }> {
  return await new Promise((resolve, reject) => {
    const asked = request({ host: '127.0.0.1', port: served.port, path, method, headers }, (answer) => {
      let text = '';
      answer.on('data', (piece: Buffer) => { text += piece.toString(); });
      answer.on('end', () => resolve({ status: answer.statusCode ?? 0, text, headers: answer.headers }));
    });
    asked.on('error', reject);
    asked.end(body);
  });
}

test('what is no message is refused, or ends its own connection alone', async () => {
  const pause = await longestPause(bystander, async () => {
    const nested = '['.repeat(50_000) + ']'.repeat(50_000);
    for (const text of ['', 'x', '{}', 'null', '[]', '{"type":"drive"', '{"type":7}', '{"type":"no_such"}', nested, '{"type":"explain","id":-1,"method":"dm"}',
      '{"type":"drive","v":1e999,"w":0}', '{"type":"drive","v":"fast","w":0}', `{"type":"hello","protocol":1,"token":"${'a'.repeat(5000)}"}`, '\u0000\u0001']) {
      const client = await Client.open(served, { hello: false });
      client.say(text);
      await client.until(() => client.closeCode !== null || client.messages.some((m) => m.type === 'error'), `refusal of ${text.slice(0, 40)}`);
      client.close();
    }
  });
  expect(pause).toBeLessThan(pauseLimitMs);
}, 60_000);

test('a frame beyond the limit closes the connection', async () => {
  const pause = await longestPause(bystander, async () => {
    const client = await Client.open(served);
    client.say(JSON.stringify({ type: 'subscribe', methods: ['x'.repeat(100_000)] }));
    expect(await client.closed()).toBe(1009);
  });
  expect(pause).toBeLessThan(pauseLimitMs);
}, 30_000);

test('frames without a mask and with reserved bits close the connection', async () => {
  for (const bytes of [Buffer.from([0x81, 0x02, 0x7b, 0x7d]), Buffer.from([0xf1, 0x80, 1, 2, 3, 4]), Buffer.from([0x81, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0, 0, 0, 0])]) {
    const socket = await raw();
    socket.write(`GET /ws?room=main HTTP/1.1\r\nHost: 127.0.0.1:${served.port}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\nSec-WebSocket-Protocol: echoarc.v1\r\nOrigin: ${served.origin}\r\n\r\n`);
    await once(socket, 'data');
    socket.write(bytes);
    expect((await drain(socket, 8000)).closed).toBe(true);
    socket.destroy();
  }
}, 40_000);

test('binary messages are refused', async () => {
  const client = await Client.open(served);
  client.socket.send(Buffer.alloc(100, 1));
  await client.until(() => client.closeCode !== null || client.messages.some((m) => m.type === 'error'), 'refusal');
  client.close();
});

test('another origin may not open a socket; the token in it would not help', async () => {
  for (const origin of ['http://evil.example', 'null', `http://127.0.0.1:${served.port}.evil.example`]) {
    const socket = new WebSocket(served.url(), 'echoarc.v1', { origin });
    const [error] = await once(socket, 'error') as [Error];
    expect(error.message).toContain('403');
  }
});

test('a wrong token may watch, not drive, and learns nothing from the refusal', async () => {
  const client = await Client.open(served, { token: 'x'.repeat(32), hello: true }).catch(() => null);
  if (client) {
    const from = client.mark();
    client.say({ type: 'take' });
    const error = await client.next<{ type: string; message: string }>('error', () => true, from);
    expect(error.message).not.toContain(served.token);
    client.close();
  }
});

test('no path leaves the page', async () => {
  for (const path of ['/../../../../etc/passwd', '/%2e%2e/%2e%2e/etc/passwd', '/..%2f..%2fetc/passwd', '//etc/passwd', '/api/map/..%2f..%2fsession', '/api/map/%00.png', '/page/../../x', '/api/log/../../etc/passwd']) {
    const answer = await get(path);
    expect([400, 404], path).toContain(answer.status);
    expect(answer.text).not.toContain('root:');
  }
});

test('every answer carries the security headers', async () => {
  for (const path of ['/', '/api/state', '/nothing-here']) {
    const { headers } = await get(path);
    expect(headers['content-security-policy'], path).toContain("default-src 'none'");
    expect(headers['content-security-policy']).not.toContain('unsafe');
    expect(headers['x-content-type-options']).toBe('nosniff');
    expect(headers['referrer-policy']).toBe('no-referrer');
  }
});

test('methods, bodies and headers beyond what is needed are refused', async () => {
  expect((await get('/', {}, 'DELETE')).status).toBe(405);
  expect((await get('/api/log', {}, 'POST', 'x')).status).toBe(401);
  expect((await get('/api/log', { authorization: 'Bearer wrong' }, 'POST', 'x')).status).toBe(401);
  const bad = await get('/api/log', { authorization: `Bearer ${served.token}` }, 'POST', 'this is no log\n');
  expect(bad.status).toBe(400);
  expect(bad.text.length).toBeGreaterThan(20);
  const socket = await raw();
  socket.write(`GET / HTTP/1.1\r\nHost: x\r\n${'X-Filler: ' + 'y'.repeat(60_000)}\r\n\r\n`);
  const { text } = await drain(socket, 5000);
  expect(text === '' || / 4\d\d /.test(text)).toBe(true);
  socket.destroy();
}, 20_000);

test('slow headers are cut off, and hold up nobody', async () => {
  const pause = await longestPause(bystander, async () => {
    const socket = await raw();
    const drained = drain(socket, 25_000);
    const drip = setInterval(() => socket.write('X-a: b\r\n'), 400);
    socket.write('GET / HTTP/1.1\r\nHost: x\r\n');
    expect((await drained).closed).toBe(true);
    clearInterval(drip);
    socket.destroy();
  });
  expect(pause).toBeLessThan(pauseLimitMs);
}, 40_000);

test('a flood of messages ends its own connection', async () => {
  const pause = await longestPause(bystander, async () => {
    const client = await Client.open(served, { token: served.token });
    for (let i = 1; i <= 20_000 && client.closeCode === null; i++) {
      client.say({ type: 'ping', id: i });
      if (i % 1000 === 0) await new Promise((resolve) => setTimeout(resolve, 1));
    }
    await client.closed();
  });
  expect(pause).toBeLessThan(pauseLimitMs);
}, 40_000);

test('more connections than the limit are turned away, later ones find room again', async () => {
  const sockets: Socket[] = [];
  for (let i = 0; i < 300; i++) sockets.push(await raw());
  await new Promise((resolve) => setTimeout(resolve, 300));
  const refused = sockets.filter((socket) => socket.destroyed || socket.readableEnded).length;
  for (const socket of sockets) socket.destroy();
  expect(refused).toBeGreaterThan(0);
  await new Promise((resolve) => setTimeout(resolve, 500));
  expect((await get('/')).status).toBe(200);
}, 30_000);
