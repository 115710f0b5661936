// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** A log with the true poses and a laser in it, let fall onto the page as from a folder. */
import { execFileSync } from 'node:child_process';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { afterAll, afterEach, beforeAll, expect, test } from 'vitest';
import { commandPath } from '../conformance/served.ts';
import { Kit } from './kit.ts';

let kit: Kit;
let log: string;

beforeAll(async () => {
  kit = await Kit.start('--scene', 'demo', '--method', 'consensus,evidence');
  log = join(kit.served.folder, 'cardboard.jsonl');
  execFileSync(commandPath(), ['sim', 'curve', '-o', log]);
}, 60_000);
afterAll(async () => { await kit?.stop(); }, 60_000);
afterEach(async () => { await kit.closePages(); });

/** As the system does it: the file comes in over the map, moves there, and is let go by what this returns. */
async function drag(page: Page, file: string): Promise<() => Promise<void>> {
  const devtools = await page.context().newCDPSession(page);
  const send = async (type: 'dragEnter' | 'dragOver' | 'drop', x: number): Promise<void> => {
    await devtools.send('Input.dispatchDragEvent', { type, x, y: 400, data: { items: [], files: [file], dragOperationsMask: 1 } });
    await page.waitForTimeout(100); // the page has to say that it takes it, as it would between two moves of a hand
  };
  await send('dragEnter', 500);
  await send('dragOver', 500);
  await page.getByText('Drop to open').waitFor();
  await send('dragOver', 504);
  return async () => { await send('drop', 504); };
}

test('a log that is dropped is mapped in a room of its own, with its score', async () => {
  const page = await kit.open({ hash: `#token=${kit.served.token}` });
  const letGo = await drag(page, log);
  await kit.picture(page, 'drop');
  await letGo();
  await page.waitForURL(/room=(?!main)/);
  await page.locator('.src b').getByText('cardboard.jsonl').waitFor();
  // Against what its laser saw.
  await page.locator('.mrow .val').getByText(/^\d+\.\d cm$/).first().waitFor({ timeout: 30_000 });
  await page.locator('.chart').getByText('Consensus').waitFor();
  await kit.picture(page, 'log');
  expect(kit.complaints).toEqual([]);
}, 90_000);

test('what is no log is refused by name, and nothing else happens', async () => {
  const page = await kit.open({ hash: `#token=${kit.served.token}` });
  const notes = join(kit.served.folder, 'notes.pdf');
  writeFileSync(notes, 'no log');
  await (await drag(page, notes))();
  await page.getByRole('alert').getByText('echoarc cannot read notes.pdf', { exact: false }).waitFor();
  expect(page.url()).not.toContain('room=');
}, 60_000);
