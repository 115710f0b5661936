// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** What a person does, in Debian's Chromium, against the real server. */
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { type Browser, type BrowserContext, chromium, type Page } from 'playwright-core';
import { afterAll, afterEach, beforeAll, expect, test } from 'vitest';
import { Served } from '../conformance/served.ts';

/** Where pictures of every state go, to be looked at; none are taken without it. */
const pictures = process.env['ECHOARC_PICTURES'];

let served: Served;
let browser: Browser;
let context: BrowserContext | null = null;
let complaints: string[] = [];

beforeAll(async () => {
  served = await Served.start('--scene', 'demo', '--method', 'consensus,evidence,atm_mod,centerline');
  browser = await chromium.launch({
    executablePath: process.env['CHROMIUM'] ?? '/usr/bin/chromium',
    args: ['--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run', '--disable-background-networking',
      '--disable-component-update', '--disable-sync'],
  });
}, 60_000);
afterAll(async () => {
  await browser?.close();
  await served?.stop();
}, 60_000);
afterEach(async () => {
  await context?.close();
  context = null;
});

async function open(hash = '', size = { width: 1440, height: 900 }, touch = false): Promise<Page> {
  complaints = [];
  context = await browser.newContext({ viewport: size, hasTouch: touch, reducedMotion: 'reduce', deviceScaleFactor: 1 });
  const page = await context.newPage();
  page.on('console', (message) => { if (message.type() === 'error') complaints.push(message.text()); });
  page.on('pageerror', (error) => complaints.push(String(error)));
  await page.goto(`${served.origin}/${hash}`);
  await page.waitForFunction(() => /[1-9]\d* pings/.test(document.querySelector('#insp')?.textContent ?? ''), undefined, { timeout: 15_000 });
  return page;
}

async function picture(page: Page, name: string): Promise<void> {
  if (!pictures) return;
  mkdirSync(pictures, { recursive: true });
  await page.screenshot({ path: join(pictures, `${name}.png`) });
}

async function pings(): Promise<number> {
  const answer = await fetch(`${served.origin}/api/state`);
  return ((await answer.json()) as { state: { pings: number } }).state.pings;
}

async function speed(): Promise<number> {
  const answer = await fetch(`${served.origin}/api/state`);
  return ((await answer.json()) as { state: { v: number } }).state.v;
}

/** Asks until it is so. */
async function until(what: string, look: () => Promise<boolean>, ms = 15_000): Promise<void> {
  const end = Date.now() + ms;
  while (!(await look())) {
    if (Date.now() > end) throw new Error(`${what}: not within ${ms} ms`);
    await new Promise((resolve) => setTimeout(resolve, 100));
  }
}

test('the first screen shows a map that grows, and nothing complains', async () => {
  const page = await open();
  const before = await pings();
  await until('more pings', async () => (await pings()) > before + 20);
  const dark = await page.evaluate(() => {
    // The map is drawn: its canvas holds more than one colour.
    const canvas = document.querySelector('#map canvas') as HTMLCanvasElement;
    const copy = document.createElement('canvas');
    copy.width = canvas.width;
    copy.height = canvas.height;
    const context2d = copy.getContext('2d') as CanvasRenderingContext2D;
    for (const one of document.querySelectorAll('#map canvas')) context2d.drawImage(one as HTMLCanvasElement, 0, 0);
    const colours = new Set<number>();
    const data = new Uint32Array(context2d.getImageData(0, 0, copy.width, copy.height).data.buffer);
    for (let i = 0; i < data.length; i += 97) colours.add(data[i] ?? 0);
    return colours.size;
  });
  expect(dark).toBeGreaterThan(5);
  await picture(page, 'live-light');
  expect(complaints).toEqual([]);
}, 60_000);

test('without the token nobody drives; with it the robot goes by key and stops by Space', async () => {
  const watcher = await open();
  await watcher.getByRole('button', { name: 'Drive', exact: true }).click();
  await watcher.getByText('drive link', { exact: false }).first().waitFor();
  await context?.close();

  const page = await open(`#token=${served.token}`);
  expect(page.url()).not.toContain(served.token);
  await page.getByRole('button', { name: 'Drive', exact: true }).click();
  await page.getByText('You are driving').waitFor();
  await page.keyboard.down('a');
  await page.keyboard.down('w');
  await until('moving', async () => Math.abs(await speed()) > 0.02);
  await picture(page, 'drive-light');
  await page.keyboard.press('Space');
  await until('standing', async () => (await speed()) === 0);
  await page.keyboard.up('w');
  await page.keyboard.up('a');
  expect(complaints).toEqual([]);
}, 60_000);

test('a hidden page lets go of the robot', async () => {
  const page = await open(`#token=${served.token}`);
  await page.getByRole('button', { name: 'Drive', exact: true }).click();
  await page.getByText('You are driving').waitFor();
  await page.keyboard.down('d');
  await page.keyboard.down('s');
  await until('moving', async () => (await speed()) !== 0);
  await page.evaluate(() => {
    Object.defineProperty(document, 'hidden', { value: true, configurable: true });
    Object.defineProperty(document, 'visibilityState', { value: 'hidden', configurable: true });
    document.dispatchEvent(new Event('visibilitychange'));
  });
  await until('standing', async () => (await speed()) === 0, 2500);
}, 60_000);

test('a point is explained, and its ping followed step by step', async () => {
  const page = await open();
  await until('pings', async () => (await pings()) > 120, 40_000);
  await page.locator('#map').focus();
  await page.keyboard.press('p');
  await page.keyboard.press('Enter');
  await page.getByRole('heading', { name: /Why is this point here/ }).waitFor();
  await page.locator('#insp table').first().waitFor();
  await picture(page, 'explain-light');
  await page.getByRole('button', { name: /Step through ping/ }).click();
  await page.getByRole('heading', { name: /step by step/ }).waitFor();
  await page.getByText('The echo').first().waitFor();
  await picture(page, 'step-light');
  expect(complaints).toEqual([]);
}, 90_000);

test('methods are compared, options changed', async () => {
  const page = await open(`#token=${served.token}`);
  await page.getByRole('link', { name: 'Compare' }).click();
  await page.getByRole('heading', { name: 'Methods over one log' }).waitFor();
  await picture(page, 'compare-light');
  await page.getByRole('link', { name: 'Map', exact: true }).click();
  await page.getByRole('button', { name: /^Options of/ }).first().click();
  await page.locator('#insp input[type=range], #insp input[type=number], #insp input[inputmode]').first().waitFor();
  await picture(page, 'options-light');
  expect(complaints).toEqual([]);
}, 60_000);

test('a broken connection is said, and the view kept when it is back', async () => {
  const page = await open('#theme=dark&l=path,truth');
  await picture(page, 'live-dark');
  served.process.kill('SIGSTOP');
  try {
    await page.getByText(/Connection lost/).first().waitFor({ timeout: 30_000 });
    await picture(page, 'lost-dark');
  } finally {
    served.process.kill('SIGCONT');
  }
  await page.getByText(/Connected again/).first().waitFor({ timeout: 20_000 });
  expect(page.url()).toContain('theme=dark');
  expect(page.url()).toContain('truth');
}, 90_000);

test('on a phone, either way, Stop is there', async () => {
  for (const [name, size] of [['phone-landscape', { width: 844, height: 390 }], ['phone-portrait', { width: 390, height: 844 }]] as const) {
    const page = await open('', size, true);
    const stop = await page.locator('#stop').boundingBox();
    expect(stop).not.toBeNull();
    if (stop) {
      expect(stop.x + stop.width).toBeLessThanOrEqual(size.width);
      expect(stop.y + stop.height).toBeLessThanOrEqual(size.height);
      expect(Math.min(stop.width, stop.height)).toBeGreaterThanOrEqual(60);
    }
    await picture(page, name);
    expect(complaints).toEqual([]);
    await context?.close();
  }
}, 60_000);
