// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/**
 * A stand-in for `echoarc serve` to develop and test the page with: serves a folder and speaks docs/protocol.md over a small
 * simulation of its own.
 *
 *   node test/fake_server/main.mjs [--port 8123] [--dir web/dist] [--begin SECONDS] [--still] [--token WORD]
 */
import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { extname, join, normalize, resolve, sep } from 'node:path';
import { parseArgs } from 'node:util';
import { WebSocketServer } from 'ws';
import { Room } from './room.mjs';
import { Viewer } from './viewer.mjs';

const { values } = parseArgs({
  options: {
    port: { type: 'string', default: '8123' }, dir: { type: 'string', default: 'dist' }, begin: { type: 'string', default: '20' },
    still: { type: 'boolean', default: false }, token: { type: 'string', default: 'letmedrive' },
  },
});
const types = { '.html': 'text/html', '.js': 'text/javascript', '.css': 'text/css', '.svg': 'image/svg+xml', '.png': 'image/png' };
const policy = "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data: blob:; connect-src 'self'";
const folder = resolve(values.dir);

const server = createServer((request, response) => {
  const path = normalize(join(folder, decodeURIComponent(new URL(request.url ?? '/', 'http://localhost').pathname)));
  const file = path === folder || path.endsWith(sep) ? join(path, 'index.html') : path;
  if (!file.startsWith(folder + sep)) { response.writeHead(404).end(); return; }
  readFile(file).then(
    (bytes) => response.writeHead(200, { 'content-type': types[extname(file)] ?? 'application/octet-stream', 'content-security-policy': policy, 'cache-control': 'no-store' }).end(bytes),
    () => response.writeHead(404).end('Not here.\n'),
  );
});

const room = new Room();
room.advance(Number(values.begin));
const viewers = new Set();
let lastId = 0;
new WebSocketServer({ server, path: '/ws', handleProtocols: (offered) => (offered.has('echoarc.v1') ? 'echoarc.v1' : false) }).on('connection', (socket) => {
  const viewer = new Viewer(socket, ++lastId, room, viewers, values.token);
  viewers.add(viewer);
  socket.on('close', () => {
    viewers.delete(viewer);
    if (room.driver === viewer.id) Object.assign(room, { driver: null });
    for (const other of viewers) other.tellViewers();
  });
});
let before = performance.now();
setInterval(() => {
  const now = performance.now();
  if (!values.still) room.advance((now - before) / 1000);
  before = now;
  for (const viewer of viewers) viewer.update();
}, 100);
setInterval(() => { for (const viewer of viewers) viewer.everySecond(); }, 1000);
server.listen(Number(values.port), '127.0.0.1', () => console.log(`http://127.0.0.1:${values.port}/#token=${values.token}`));
