// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Looking back: a moment that is held, and one ping followed from the map before it to the map after it. */
import type { Page } from 'playwright-core';
import { afterAll, afterEach, beforeAll, expect, test } from 'vitest';
import { Kit, until } from './kit.ts';

let kit: Kit;

beforeAll(async () => {
  kit = await Kit.start('--scene', 'demo', '--method', 'consensus,evidence');
  await until('pings', async () => (await kit.pings()) > 130, 40_000);
}, 60_000);
afterAll(async () => { await kit?.stop(); }, 60_000);
afterEach(async () => { await kit.closePages(); });

test('while a moment is held, Explain says that it speaks of the live map, and of the same ping', async () => {
  const page = await kit.open();
  await page.locator('#map').focus();
  await page.keyboard.press('k');
  await page.getByRole('button', { name: 'Back to live' }).waitFor();
  await page.waitForTimeout(500); // the map of then is on its way
  await page.keyboard.press('p');
  const tag = page.locator('#map > .map-tag[role=status]');
  await tag.waitFor();
  const ping = /ping ([\d,]+)$/.exec(await tag.textContent() ?? '')?.[1] ?? 'none';
  await page.keyboard.press('Enter');
  await page.getByText(`Along the arc of ping ${ping}`, { exact: true }).waitFor();
  const note = page.locator('.held-note');
  expect(await note.textContent()).toMatch(/^This explains the live map, not the moment \d+:\d\d that is shown\./);
  await kit.picture(page, 'explain-held');
  await note.getByRole('button', { name: 'Back to live' }).click();
  await note.waitFor({ state: 'detached' });
  expect(kit.complaints).toEqual([]);
}, 60_000);

/** What lies on the ground canvas, and how many pixels over it have the colours of cells that change. */
async function seen(page: Page): Promise<{ ground: string; changed: number }> {
  await page.waitForTimeout(300);
  return await page.evaluate(() => {
    const pixels = (selector: string): Uint8ClampedArray => {
      const canvas = document.querySelector(selector) as HTMLCanvasElement;
      const copy = document.createElement('canvas');
      [copy.width, copy.height] = [canvas.width, canvas.height];
      const g = copy.getContext('2d') as CanvasRenderingContext2D;
      g.drawImage(canvas, 0, 0);
      return g.getImageData(0, 0, copy.width, copy.height).data;
    };
    const over = pixels('#map canvas.over');
    let changed = 0;
    for (let i = 0; i < over.length; i += 4) if ((over[i + 3] ?? 0) > 20 && (over[i] ?? 0) > 140 && (over[i] ?? 0) - (over[i + 2] ?? 0) > 60) changed++;
    return { ground: pixels('#map canvas:not(.over)').reduce((sum, v, i) => (sum * 31 + v * (1 + (i % 7))) >>> 0, 7).toString(16), changed };
  });
}

test('the last step shows the map after the ping, the one before it what changes', async () => {
  const page = await kit.open({ hash: '#v=step&ping=97&step=3&m=evidence', wait: false });
  const part = (n: number) => page.locator(`[data-key="part-${n}"]`);
  await part(3).waitFor();
  await page.getByRole('button', { name: 'Back to live' }).waitFor();
  const arc = await seen(page);
  await part(4).click();
  const cells = await seen(page);
  await kit.picture(page, 'step-cells');
  await part(5).click();
  const after = await seen(page);
  await kit.picture(page, 'step-after');
  expect(arc.changed).toBe(0);
  expect(cells.changed).toBeGreaterThan(20);
  expect(after.changed).toBe(0);
  expect(cells.ground).toBe(arc.ground);
  expect(after.ground).not.toBe(arc.ground);
  expect(kit.complaints).toEqual([]);
}, 60_000);

test('points of the method are on the map before the ping, and keys go from ping to ping', async () => {
  const page = await kit.open({ hash: '#v=step&ping=97&step=2&m=consensus,evidence', wait: false });
  await page.getByRole('heading', { name: 'Ping 97, step by step' }).waitFor();
  await page.locator('.step.now').waitFor();
  const withPoints = await seen(page);
  await page.evaluate(() => { location.hash = location.hash.replace('m=consensus,evidence', 'm=evidence'); });
  await page.locator('.step.now').waitFor();
  await until('other ground', async () => (await seen(page)).ground !== withPoints.ground);
  await page.locator('#map').focus();
  for (const [key, ping] of [[',', 96], ['<', 80], ['.', 81], ['>', 97]] as const) {
    await page.keyboard.press(key);
    await page.getByRole('heading', { name: `Ping ${ping}, step by step` }).waitFor();
  }
  expect(kit.complaints).toEqual([]);
}, 60_000);
