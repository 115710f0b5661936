// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/**
 * Measures how fast the map draws under software rendering: `node test/bench/run.mjs [--seconds 5]`. Prints one line of CSV per
 * scale and path; needs Debian's chromium and esbuild.
 */
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { createServer } from 'node:http';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { chromium } from 'playwright-core';

const web = dirname(dirname(dirname(fileURLToPath(import.meta.url))));
const { values } = parseArgs({ options: { seconds: { type: 'string', default: '5' } } });
const folder = mkdtempSync(join(tmpdir(), 'echoarc-bench-'));
execFileSync(join(web, 'build.sh'), ['bench', folder], { stdio: 'inherit' });
const server = createServer((request, response) => {
  const name = { '/': 'index.html', '/main.js': 'main.js', '/demo.css': 'demo.css' }[new URL(request.url ?? '/', 'http://localhost').pathname];
  if (!name) { response.writeHead(404).end(); return; }
  const type = { html: 'text/html', js: 'text/javascript', css: 'text/css' }[name.split('.').at(-1)];
  response.writeHead(200, { 'content-type': type }).end(readFileSync(join(folder, name)));
});
await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
const quiet = ['--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync'];
console.log('renderer,drawn_by,px_per_m,frames_per_s,p95_ms');
for (const path of ['auto', 'canvas2d', 'webgl2']) {
  const browser = await chromium.launch({ executablePath: '/usr/bin/chromium', args: quiet });
  const page = await browser.newPage({ viewport: { width: 1440, height: 900 } });
  await page.goto(`http://127.0.0.1:${server.address().port}/?renderer=${path}`);
  for (const scale of [8, 30, 60]) {
    const { framesPerS, p95Ms, accelerated } = await page.evaluate(([s, n]) => window.measure(s, n), [scale, Number(values.seconds)]);
    console.log(`${path},${accelerated ? 'webgl2' : 'canvas2d'},${scale},${framesPerS.toFixed(1)},${p95Ms.toFixed(1)}`);
  }
  await browser.close();
}
server.close();
rmSync(folder, { recursive: true });
