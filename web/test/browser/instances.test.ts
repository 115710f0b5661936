// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** One method several times over, as a person sees it: the outlier tests side by side, defaults under the divider, options of a link. */
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { type Browser, chromium, type Page } from 'playwright-core';
import { afterAll, beforeAll, expect, test } from 'vitest';
import { Client, type Message, Served } from '../conformance/served.ts';

const pictures = process.env['ECHOARC_PICTURES'];

let served: Served;
let browser: Browser;
let complaints: string[] = [];

beforeAll(async () => {
  served = await Served.start('--scene', 'demo', '--method', 'carve,numakura');
  browser = await chromium.launch({ executablePath: process.env['CHROMIUM'] ?? '/usr/bin/chromium', args: ['--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run'] });
}, 60_000);
afterAll(async () => {
  await browser?.close();
  await served?.stop();
}, 60_000);

async function open(hash: string): Promise<Page> {
  complaints = [];
  const context = await browser.newContext({ viewport: { width: 1440, height: 900 }, reducedMotion: 'reduce', deviceScaleFactor: 1 });
  const page = await context.newPage();
  page.on('console', (message) => { if (message.type() === 'error') complaints.push(message.text()); });
  page.on('pageerror', (error) => complaints.push(String(error)));
  await page.goto(`${served.origin}/${hash}`);
  await page.locator('#sens button').first().waitFor();
  return page;
}

async function picture(page: Page, name: string): Promise<void> {
  if (!pictures) return;
  mkdirSync(pictures, { recursive: true });
  await page.screenshot({ path: join(pictures, `${name}.png`) });
}

type Told = Message & { running: { method: string; name: string; options: Record<string, boolean | number> }[] };

async function running(accept: (ids: string[]) => boolean): Promise<Told['running']> {
  const client = await Client.open(served);
  const told = await client.next<Told>('methods', (m) => accept(m.running.map((r) => r.method)));
  client.close();
  return told.running;
}

test('Numakura’s four maps lie side by side at one press, once', async () => {
  const page = await open(`#token=${served.token}`);
  await page.getByRole('link', { name: 'Compare' }).click();
  for (let i = 0; i < 2; i++) {
    await page.getByRole('button', { name: /^Outliers/ }).click();
    for (const label of ['Numakura no test', 'Numakura test 1', 'Numakura test 2'])
      await page.locator('#over .pl b').getByText(label).waitFor();
  }
  const all = await running((ids) => ids.includes('numakura-test-2'));
  expect(all.map((r) => r.method)).toEqual(['carve', 'numakura', 'numakura-no-test', 'numakura-test-1', 'numakura-test-2']);
  expect(all.slice(1).map((r) => [r.options['geometry_test'], r.options['consistency_test']])).toEqual([[true, true], [false, false], [true, false], [false, true]]);
  await page.waitForTimeout(500);
  await picture(page, 'compare-outliers');
  expect(complaints).toEqual([]);
  await page.context().close();
}, 60_000);

test('a changed method is compared with its defaults', async () => {
  const page = await open(`#v=options&of=carve&token=${served.token}`);
  const field = page.getByRole('textbox', { name: 'Guard' });
  await field.fill('4');
  await field.press('Enter');
  await page.getByRole('button', { name: 'Compare with default' }).click();
  await page.locator('#over .pl b').getByText('Arc carving default').waitFor();
  await page.getByRole('slider', { name: 'Divider' }).waitFor();
  expect((await running((ids) => ids.includes('carve-default'))).find((r) => r.method === 'carve-default')?.name).toBe('carve');
  await picture(page, 'compare-default');
  expect(complaints).toEqual([]);
  await page.context().close();
}, 60_000);

test('options of a link are offered; who has the token may apply them', async () => {
  const watcher = await open('#o.carve.guard_m=0.01');
  await watcher.getByText(/Apply these options/).waitFor();
  await watcher.getByRole('button', { name: 'Apply' }).click();
  await watcher.getByText('drive link', { exact: false }).first().waitFor();
  await watcher.context().close();

  const page = await open(`#o.carve.guard_m=0.01&o.numakura.jump_m=9999&token=${served.token}`);
  await picture(page, 'link-options');
  await page.getByRole('button', { name: 'Apply' }).click();
  const client = await Client.open(served);
  await client.next<Told>('methods', (m) => m.running.some((r) => r.method === 'carve' && r.options['guard_m'] === 0.01));
  client.close();
  await page.waitForFunction(() => !location.hash.includes('o.carve'));
  expect(complaints).toEqual([]);
  await page.context().close();
}, 60_000);
