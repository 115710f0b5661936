// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** What a person does, in Debian's Chromium, against the real server. */
import type { Page } from 'playwright-core';
import { afterAll, afterEach, beforeAll, expect, test } from 'vitest';
import { Kit, until } from './kit.ts';

let kit: Kit;

beforeAll(async () => { kit = await Kit.start('--scene', 'demo', '--method', 'consensus,evidence,atm_mod,centerline'); }, 60_000);
afterAll(async () => { await kit?.stop(); }, 60_000);
afterEach(async () => { await kit.closePages(); });

test('the first screen shows a map that grows, and nothing complains', async () => {
  const page = await kit.open();
  const before = await kit.pings();
  await until('more pings', async () => (await kit.pings()) > before + 20);
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
  await kit.picture(page, 'live-light');
  expect(kit.complaints).toEqual([]);
}, 60_000);

test('without the token nobody drives; with it the robot goes by key and stops by Space', async () => {
  const watcher = await kit.open();
  await watcher.getByRole('button', { name: 'Drive', exact: true }).click();
  await watcher.getByText('drive link', { exact: false }).first().waitFor();
  await kit.closePages();

  const page = await kit.open({ hash: `#token=${kit.served.token}` });
  expect(page.url()).not.toContain(kit.served.token);
  await page.getByRole('button', { name: 'Drive', exact: true }).click();
  await page.getByText('You are driving').waitFor();
  await page.keyboard.down('a');
  await page.keyboard.down('w');
  await until('moving', async () => Math.abs(await kit.speed()) > 0.02);
  await kit.picture(page, 'drive-light');
  await page.keyboard.press('Space');
  await until('standing', async () => (await kit.speed()) === 0);
  await page.keyboard.up('w');
  await page.keyboard.up('a');
  expect(kit.complaints).toEqual([]);
}, 60_000);

test('a hidden page sends no more commands, and the robot stands', async () => {
  const sent: { type: string; v?: number; w?: number }[] = [];
  const page = await kit.open({
    hash: `#token=${kit.served.token}`,
    prepare: async (fresh) => { fresh.on('websocket', (socket) => socket.on('framesent', ({ payload }) => sent.push(JSON.parse(String(payload)) as { type: string }))); },
  });
  await page.getByRole('button', { name: 'Drive', exact: true }).click();
  await page.getByText('You are driving').waitFor();
  await page.keyboard.down('d');
  await page.keyboard.down('s');
  await until('moving', async () => (await kit.speed()) !== 0);
  const before = sent.length;
  await page.evaluate(() => {
    Object.defineProperty(document, 'hidden', { value: true, configurable: true });
    Object.defineProperty(document, 'visibilityState', { value: 'hidden', configurable: true });
    document.dispatchEvent(new Event('visibilitychange'));
  });
  await until('standing', async () => (await kit.speed()) === 0, 2500);
  const types = sent.slice(before).map((m) => m.type);
  // What was on its way may have gone out before the page heard that it is hidden; after its farewell nothing does.
  const farewell = types.indexOf('release');
  expect(farewell).toBeGreaterThan(0);
  expect(sent[before + farewell - 1]).toMatchObject({ type: 'drive', v: 0, w: 0 });
  expect(types.slice(farewell + 1)).not.toContain('drive');
}, 60_000);

test('so does one that is left while it drives', async () => {
  const page = await kit.open({ hash: `#token=${kit.served.token}` });
  await page.getByRole('button', { name: 'Drive', exact: true }).click();
  await page.getByText('You are driving').waitFor();
  await page.keyboard.down('a');
  await until('moving', async () => (await kit.turning()) !== 0);
  await page.goto('about:blank');
  await until('standing, nobody drives', async () => (await kit.turning()) === 0 && (await kit.driver()) === null, 2500);
}, 60_000);

test('a point is explained, and its ping followed step by step', async () => {
  const page = await kit.open();
  await until('pings', async () => (await kit.pings()) > 120, 40_000);
  await page.locator('#map').focus();
  await page.keyboard.press('p');
  await page.keyboard.press('Enter');
  await page.getByRole('heading', { name: /Why is this point here/ }).waitFor();
  await page.locator('#insp table').first().waitFor();
  await kit.picture(page, 'explain-light');
  await page.getByRole('button', { name: /Step through ping/ }).click();
  await page.getByRole('heading', { name: /step by step/ }).waitFor();
  await page.getByText('The echo').first().waitFor();
  await kit.picture(page, 'step-light');
  expect(kit.complaints).toEqual([]);
}, 90_000);

test('methods are compared, options changed', async () => {
  const page = await kit.open({ hash: `#token=${kit.served.token}` });
  await page.getByRole('link', { name: 'Compare' }).click();
  await page.getByRole('heading', { name: 'Methods over one log' }).waitFor();
  await kit.picture(page, 'compare-light');
  await page.getByRole('link', { name: 'Map', exact: true }).click();
  await page.getByRole('button', { name: /^Options of/ }).first().click();
  await page.locator('#insp input[type=range], #insp input[type=number], #insp input[inputmode]').first().waitFor();
  await kit.picture(page, 'options-light');
  expect(kit.complaints).toEqual([]);
}, 60_000);

test('a broken connection is said, and the view kept when it is back', async () => {
  const page = await kit.open({ hash: '#theme=dark&l=path,truth' });
  await kit.picture(page, 'live-dark');
  kit.served.process.kill('SIGSTOP');
  try {
    await page.getByText(/Connection lost/).first().waitFor({ timeout: 30_000 });
    await kit.picture(page, 'lost-dark');
  } finally {
    kit.served.process.kill('SIGCONT');
  }
  await page.getByText(/Connected again/).first().waitFor({ timeout: 20_000 });
  expect(page.url()).toContain('theme=dark');
  expect(page.url()).toContain('truth');
}, 90_000);

for (const [name, size] of [['phone-landscape', { width: 844, height: 390 }], ['phone-portrait', { width: 390, height: 844 }], ['phone-small', { width: 320, height: 568 }]] as const) {
  /** Stop is whole on the screen, and what is hit in its middle and at four places around it is Stop. */
  const expectStop = async (page: Page): Promise<void> => {
    const stop = await page.locator('#stop').boundingBox();
    expect(stop).not.toBeNull();
    if (!stop) return;
    expect(stop.x).toBeGreaterThanOrEqual(0);
    expect(stop.y).toBeGreaterThanOrEqual(0);
    expect(stop.x + stop.width).toBeLessThanOrEqual(size.width);
    expect(stop.y + stop.height).toBeLessThanOrEqual(size.height);
    expect(Math.min(stop.width, stop.height)).toBeGreaterThanOrEqual(60);
    const hits = await page.evaluate(({ x, y, width, height }) => [[0.5, 0.5], [0.2, 0.5], [0.8, 0.5], [0.5, 0.1], [0.5, 0.9]]
      .map(([a, b]) => document.elementFromPoint(x + (a ?? 0) * width, y + (b ?? 0) * height)?.closest('#stop') !== null), stop);
    expect(hits).toEqual([true, true, true, true, true]);
  };

  test(`${name}: nothing covers Stop, and what is asked for is shown`, async () => {
    const page = await kit.open({ size, touch: true });
    await expectStop(page);
    await kit.picture(page, name);
    await page.getByRole('link', { name: 'Step', exact: true }).tap();
    await page.getByRole('heading', { name: /step by step/ }).waitFor();
    await page.getByText('Where the sensor was').first().waitFor();
    expect((await page.locator('#insp').boundingBox())?.height ?? 0).toBeGreaterThan(190);
    await expectStop(page);
    await kit.picture(page, `${name}-step`);
    if (size.width > size.height) {
      await page.getByRole('button', { name: 'Close' }).tap();
      await expectStop(page);
      await page.getByRole('link', { name: 'Step', exact: true }).tap();
      await page.locator('#insp').waitFor({ state: 'visible' });
    }
    for (let stop = 0; stop < 3 && size.height > size.width; stop++) {
      await page.locator('.handle').tap({ position: { x: 60, y: 8 } });
      await expectStop(page);
    }
    expect(kit.complaints).toEqual([]);
  }, 60_000);

  test(`${name}: a tapped point opens its sheet, and a menu keeps off Stop`, async () => {
    await until('points', async () => (await kit.pings()) > 120, 40_000);
    const page = await kit.open({ hash: `#token=${kit.served.token}`, size, touch: true });
    await page.locator('.toast').waitFor({ state: 'detached' }); // a point may lie under it
    await page.locator('#map').focus();
    await page.keyboard.press('p');
    const tag = page.locator('#map > .map-tag[role=status]');
    await tag.waitFor();
    const at = await tag.evaluate((e) => { const b = e.getBoundingClientRect(); return { x: b.left + Number.parseFloat((e as HTMLElement).style.getPropertyValue('--tip')), y: b.bottom + 10 }; });
    await page.touchscreen.tap(at.x, at.y);
    await page.getByRole('heading', { name: /Why is this point here/ }).waitFor();
    await page.locator('.explain-facts').waitFor();
    await expectStop(page);
    await kit.picture(page, `${name}-explain`);
    await page.getByRole('button', { name: /^Methods and layers/ }).filter({ visible: true }).tap();
    await page.getByRole('button', { name: '+ Add method' }).tap();
    await page.getByRole('menu').waitFor();
    await expectStop(page);
    await kit.picture(page, `${name}-menu`);
    expect(kit.complaints).toEqual([]);
  }, 60_000);
}
