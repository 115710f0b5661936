// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** A server of the test's own: `echoarc serve` on a free port of the loopback. */
import { type ChildProcess, spawn } from 'node:child_process';
import { once } from 'node:events';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import WebSocket from 'ws';

const link = /http:\/\/[^\s/]*:(\d+)\/#token=([\w-]+)/;

export function commandPath(): string {
  const command = process.env['ECHOARC_COMMAND'];
  if (!command) throw new Error('set ECHOARC_COMMAND to the echoarc command (./dev test does)');
  return command;
}

export class Served {
  private constructor(
    readonly process: ChildProcess, readonly port: number, readonly token: string, readonly folder: string,
    readonly output: () => string,
  ) {}

  static async start(...args: string[]): Promise<Served> {
    const folder = mkdtempSync(join(tmpdir(), 'echoarc-serve-'));
    const child = spawn(commandPath(), ['serve', '-o', join(folder, 'session'), ...args], { stdio: ['ignore', 'pipe', 'pipe'] });
    let text = '';
    return await new Promise((resolve, reject) => {
      const give_up = setTimeout(() => { child.kill('SIGKILL'); reject(new Error(`no link was printed:\n${text}`)); }, 30_000);
      const look = (piece: Buffer): void => {
        text += piece.toString();
        const found = link.exec(text);
        if (!found) return;
        clearTimeout(give_up);
        resolve(new Served(child, Number(found[1]), found[2] ?? '', folder, () => text));
      };
      child.stdout?.on('data', look);
      child.stderr?.on('data', look);
      child.on('exit', (code) => { clearTimeout(give_up); reject(new Error(`ended with ${code}:\n${text}`)); });
    });
  }

  get origin(): string { return `http://127.0.0.1:${this.port}`; }
  url(room = 'main'): string { return `ws://127.0.0.1:${this.port}/ws?room=${room}`; }

  async stop(): Promise<number | null> {
    if (this.process.exitCode === null) {
      const ended = once(this.process, 'exit');
      this.process.kill('SIGINT');
      const late = setTimeout(() => this.process.kill('SIGKILL'), 20_000);
      await ended;
      clearTimeout(late);
    }
    rmSync(this.folder, { recursive: true, force: true });
    return this.process.exitCode;
  }
}

export interface Message { type: string; [key: string]: unknown }

/** An independent client: everything it was sent, in order. */
export class Client {
  readonly messages: Message[] = [];
  readonly frames: Buffer[] = [];
  /** performance.now() of every state. */
  readonly stateTimes: number[] = [];
  closeCode: number | null = null;
  private waiting: (() => void)[] = [];

  private constructor(readonly socket: WebSocket) {
    socket.on('message', (data: Buffer, binary: boolean) => {
      if (binary) this.frames.push(data);
      else {
        const message = JSON.parse(data.toString()) as Message;
        this.messages.push(message);
        if (message.type === 'state') this.stateTimes.push(performance.now());
      }
      this.wake();
    });
    socket.on('close', (code) => { this.closeCode = code; this.wake(); });
    socket.on('error', () => this.wake());
  }

  static async open(served: Served, options: { token?: string; room?: string; hello?: boolean; origin?: string } = {}): Promise<Client> {
    const socket = new WebSocket(served.url(options.room), 'echoarc.v1', { origin: options.origin ?? served.origin });
    const client = new Client(socket);
    await once(socket, 'open');
    if (options.hello !== false) {
      client.say({ type: 'hello', protocol: 1, ...(options.token === undefined ? {} : { token: options.token }) });
      await client.next('welcome');
    }
    return client;
  }

  say(message: unknown): void { this.socket.send(typeof message === 'string' ? message : JSON.stringify(message)); }

  /** The first message of that type (and, if given, that accepts) since `from`; waits for it. */
  async next<T extends Message>(type: string, accept: (message: T) => boolean = () => true, from = 0, timeoutMs = 10_000): Promise<T> {
    return await this.until(() => this.messages.slice(from).find((m) => m.type === type && accept(m as T)) as T | undefined, `'${type}'`, timeoutMs);
  }

  /** What comes after now. */
  mark(): number { return this.messages.length; }

  async until<T>(look: () => T | undefined | null | false, what: string, timeoutMs = 10_000): Promise<T> {
    const end = performance.now() + timeoutMs;
    for (;;) {
      const found = look();
      if (found) return found;
      if (performance.now() > end) throw new Error(`${what} did not come within ${timeoutMs} ms; last: ${JSON.stringify(this.messages.slice(-3)).slice(0, 600)}`);
      await new Promise<void>((resolve) => {
        const timer = setTimeout(resolve, 50);
        this.waiting.push(() => { clearTimeout(timer); resolve(); });
      });
    }
  }

  async closed(timeoutMs = 15_000): Promise<number> {
    return await this.until(() => (this.closeCode === null ? undefined : { code: this.closeCode }), 'the close', timeoutMs).then((c) => c.code);
  }

  close(): void { this.socket.close(); }

  private wake(): void {
    const all = this.waiting;
    this.waiting = [];
    for (const resolve of all) resolve();
  }
}

/** Longest pause between two states while `disturb` runs and half a second after it, ms. */
export async function longestPause(bystander: Client, disturb: () => Promise<void>): Promise<number> {
  const first = bystander.stateTimes.length;
  await new Promise((resolve) => setTimeout(resolve, 300));
  await disturb();
  await new Promise((resolve) => setTimeout(resolve, 500));
  const times = [...bystander.stateTimes.slice(first), performance.now()];
  return Math.max(...times.slice(1).map((t, i) => t - (times[i] ?? t)));
}
