// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** A robot that finds its way by itself: started from the menu, seen on the map, stopped. */
import type { Page } from 'playwright-core';
import { afterAll, afterEach, beforeAll, expect, test } from 'vitest';
import { Kit, until } from './kit.ts';

let kit: Kit;

beforeAll(async () => { kit = await Kit.start('--scene', 't-world', '--method', 'consensus,evidence', '--speed', '4'); }, 60_000);
afterAll(async () => { await kit?.stop(); }, 60_000);
afterEach(async () => { await kit.closePages(); });

interface Strategic { mode: string; v: number; detail: string; distance_m: number }
const state = async (): Promise<Strategic> => (await kit.state()) as unknown as Strategic;
const planFact = (page: Page): Promise<string> => page.locator('#layers .lrow', { hasText: 'Plan' }).locator('.m').innerText();

/** What is drawn over the ground: a number that differs when it does. */
const overlay = (page: Page): Promise<number> => page.evaluate(() => {
  const canvas = document.querySelector('#map canvas.over') as HTMLCanvasElement;
  const data = (canvas.getContext('2d') as CanvasRenderingContext2D).getImageData(0, 0, canvas.width, canvas.height).data;
  let drawn = 0;
  for (let i = 3; i < data.length; i += 4) if ((data[i] ?? 0) > 0) drawn++;
  return drawn;
});

async function choose(page: Page, name: string): Promise<void> {
  await page.locator('button.chip').click();
  await page.getByRole('menuitem', { name, exact: true }).click();
}

for (const [name, mode, now] of [
  ['Explore frontiers', 'frontier', 'Exploring frontiers'], ['Explore Voronoi graph', 'gvg', 'Exploring the Voronoi graph'],
  ['Follow left wall', 'wall-left', 'Following the left wall'], ['Follow right wall', 'wall-right', 'Following the right wall'],
  ['Return home', 'home', 'Returning home'],
] as const) {
  test(`${name}: the robot moves, and Space stops it`, async () => {
    const page = await kit.open({ hash: `#token=${kit.served.token}` });
    const before = await state();
    await choose(page, name);
    await page.locator('button.chip', { hasText: now }).waitFor();
    await until('a mode', async () => (await state()).mode === mode);
    await until('a way', async () => (await state()).distance_m > before.distance_m + 0.1, 30_000);
    await until('words', async () => (await page.locator('.chip .doing').innerText()) !== '');
    await page.locator('#map').focus();
    await page.keyboard.press('Space');
    await until('standing', async () => { const s = await state(); return s.v === 0 && s.mode === 'stand'; });
    await until('no plan', async () => (await planFact(page)) === 'nothing planned');
    expect(kit.complaints).toEqual([]);
  }, 60_000);
}

test('the plan is a layer that can be switched off, and its link says so', async () => {
  const page = await kit.open({ hash: `#token=${kit.served.token}&arcs=s99` });
  await choose(page, 'Explore frontiers');
  await until('frontiers', async () => /frontier/.test(await planFact(page)), 30_000);
  await kit.picture(page, 'plan-light');
  expect(await page.locator('button.chip .ic').count()).toBeGreaterThan(0);
  const drawn = await overlay(page);
  await page.getByRole('checkbox', { name: 'Plan', exact: true }).uncheck();
  await until('less drawn', async () => (await overlay(page)) < drawn);
  await until('the link', async () => !/[=,]plan/.test(page.url()));
  await page.getByRole('button', { name: 'Stop', exact: false }).first().click();
  await until('standing', async () => (await state()).mode === 'stand');
  expect(kit.complaints).toEqual([]);
}, 60_000);

test('click-to-go plans its way, and says when it is there or why not', async () => {
  const page = await kit.open({ hash: `#token=${kit.served.token}` });
  await page.locator('#map').focus();
  await page.keyboard.press('g');
  const box = await page.locator('#map').boundingBox();
  if (!box) throw new Error('there is no map');
  await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
  await until('going', async () => (await state()).mode === 'goto');
  await page.locator('.toast', { hasText: /^Go to point: (done|given up)/ }).waitFor({ timeout: 90_000 });
  expect((await state()).mode).toBe('stand');
  expect(kit.complaints).toEqual([]);
}, 120_000);
