// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** A server, a browser, and pages in it, for tests of what a person does. */
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { type Browser, type BrowserContext, chromium, type Page } from 'playwright-core';
import { Served } from '../conformance/served.ts';

/** Where pictures of every state go, to be looked at; none are taken without it. */
const pictures = process.env['ECHOARC_PICTURES'];

export interface PageWish { hash?: string; size?: { width: number; height: number }; touch?: boolean; /** Before the page is asked for. */ prepare?: (page: Page) => Promise<void>; /** Whether to wait until pings are there; so it is unless told. */ wait?: boolean }

export class Kit {
  complaints: string[] = [];
  private readonly contexts: BrowserContext[] = [];

  private constructor(readonly served: Served, readonly browser: Browser) {}

  static async start(...args: string[]): Promise<Kit> {
    const served = await Served.start(...args);
    const browser = await chromium.launch({
      executablePath: process.env['CHROMIUM'] ?? '/usr/bin/chromium',
      args: ['--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run', '--disable-background-networking',
        '--disable-component-update', '--disable-sync'],
    });
    return new Kit(served, browser);
  }

  async stop(): Promise<void> {
    await this.browser.close();
    await this.served.stop();
  }

  async closePages(): Promise<void> {
    for (const context of this.contexts.splice(0)) await context.close();
  }

  async open({ hash = '', size = { width: 1440, height: 900 }, touch = false, prepare, wait = true }: PageWish = {}): Promise<Page> {
    this.complaints = [];
    const context = await this.browser.newContext({ viewport: size, hasTouch: touch, reducedMotion: 'reduce', deviceScaleFactor: 1 });
    this.contexts.push(context);
    const page = await context.newPage();
    page.on('console', (message) => { if (message.type() === 'error') this.complaints.push(message.text()); });
    page.on('pageerror', (error) => this.complaints.push(String(error)));
    await prepare?.(page);
    await page.goto(`${this.served.origin}/${hash}`);
    if (wait) await page.waitForFunction(() => /[1-9]\d* pings/.test(document.querySelector('#insp')?.textContent ?? ''), undefined, { timeout: 15_000 });
    return page;
  }

  async picture(page: Page, name: string): Promise<void> {
    if (!pictures) return;
    mkdirSync(pictures, { recursive: true });
    await page.screenshot({ path: join(pictures, `${name}.png`) });
  }

  async state(): Promise<{ pings: number; v: number; w: number; t: number; driver: number | null }> {
    const answer = await fetch(`${this.served.origin}/api/state`);
    return ((await answer.json()) as { state: { pings: number; v: number; w: number; t: number; driver: number | null } }).state;
  }

  pings = async (): Promise<number> => (await this.state()).pings;
  turning = async (): Promise<number> => (await this.state()).w;
  driver = async (): Promise<number | null> => (await this.state()).driver;
  speed = async (): Promise<number> => (await this.state()).v;
}

/** Asks until it is so. */
export async function until(what: string, look: () => Promise<boolean>, ms = 15_000): Promise<void> {
  const end = Date.now() + ms;
  while (!(await look())) {
    if (Date.now() > end) throw new Error(`${what}: not within ${ms} ms`);
    await new Promise((resolve) => setTimeout(resolve, 100));
  }
}
