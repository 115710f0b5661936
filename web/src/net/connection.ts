// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

import type { ConnectionState } from '../model/model.ts';
import type { Bye, FromClient, FromServer } from '../protocol/messages.ts';
import { backoffMs } from './backoff.ts';

export const subprotocol = 'echoarc.v1';
const closeSlow = 4008;
const openTimeoutMs = 8000;
/** A connection without any word for so long is taken for dead: states come ten times a second, pongs each second. */
const silenceMs = 5000;

export interface Hearer {
  hello(): FromClient;
  message(message: FromServer): void;
  frame(bytes: ArrayBuffer): void;
  /** Phase, round trip or rate changed. */
  changed(): void;
  broken(): void;
  nextId(): number;
}

/** The WebSocket to the server: opens it, says hello, measures it, and opens it anew when it breaks. Queues nothing. */
export class Connection {
  readonly state: ConnectionState = {
    phase: 'connecting', sinceMs: performance.now(), attempt: 0, retryAtMs: Number.NaN, roundTripMs: Number.NaN, bytesPerS: 0,
    reason: '', pingsWhenLost: 0, versionDiffers: false,
  };
  private socket: WebSocket | null = null;
  private retryTimer: ReturnType<typeof setTimeout> | undefined;
  private beatTimer: ReturnType<typeof setInterval> | undefined;
  private bytes = 0;
  private heardMs = 0;
  private pinged: { id: number; atMs: number } | null = null;

  constructor(private readonly url: string, private readonly hearer: Hearer) {}

  start(): void {
    this.beatTimer ??= setInterval(() => this.beat(), 1000);
    this.open();
  }

  retryNow(): void {
    if (this.socket?.readyState === WebSocket.OPEN) return;
    this.drop();
    this.state.reason = '';
    if (this.state.phase === 'ended') this.enter('lost');
    this.open();
  }

  close(): void {
    clearInterval(this.beatTimer);
    this.beatTimer = undefined;
    clearTimeout(this.retryTimer);
    this.drop();
  }

  /** False, and nothing kept for later, when the connection is not open. */
  send(message: FromClient): boolean {
    if (this.socket?.readyState !== WebSocket.OPEN) return false;
    this.socket.send(JSON.stringify(message));
    return true;
  }

  private open(): void {
    clearTimeout(this.retryTimer);
    this.state.retryAtMs = Number.NaN;
    this.state.attempt++;
    const socket = new WebSocket(this.url, subprotocol);
    socket.binaryType = 'arraybuffer';
    this.socket = socket;
    const own = (act: () => void) => () => { if (this.socket === socket) act(); };
    const late = setTimeout(own(() => this.lose()), openTimeoutMs);
    socket.onopen = own(() => {
      clearTimeout(late);
      this.heardMs = performance.now();
      this.send(this.hearer.hello());
    });
    socket.onmessage = (event) => { if (this.socket === socket) this.hear(event.data as string | ArrayBuffer); };
    socket.onclose = (event) => {
      clearTimeout(late);
      if (this.socket !== socket) return;
      if (event.code === closeSlow && this.state.reason === '') this.state.reason = 'slow';
      this.lose();
    };
    this.hearer.changed();
  }

  private hear(data: string | ArrayBuffer): void {
    this.heardMs = performance.now();
    if (typeof data !== 'string') {
      this.bytes += data.byteLength;
      this.hearer.frame(data);
      return;
    }
    this.bytes += data.length;
    let message: FromServer;
    try {
      message = JSON.parse(data) as FromServer;
    } catch {
      console.error('The server sent text that is not JSON.');
      return;
    }
    if (message.type === 'welcome') this.welcomed();
    else if (message.type === 'bye') this.state.reason = message.reason satisfies Bye['reason'];
    else if (message.type === 'pong' && message.id === this.pinged?.id) {
      this.state.roundTripMs = performance.now() - this.pinged.atMs;
      this.pinged = null;
    }
    this.hearer.message(message);
  }

  private welcomed(): void {
    this.state.attempt = 0;
    this.state.reason = '';
    this.enter('live');
    this.ping();
  }

  private lose(): void {
    this.drop();
    const { reason } = this.state;
    const final = reason === 'slow' || reason === 'room_closed' || reason === 'limit';
    this.hearer.broken();
    if (final) {
      this.enter('ended');
      return;
    }
    const waitMs = backoffMs(this.state.attempt);
    this.state.retryAtMs = performance.now() + waitMs;
    this.retryTimer = setTimeout(() => this.open(), waitMs);
    // The first attempts of a page that never was connected are no loss of a connection.
    if (this.state.phase !== 'connecting' && this.state.phase !== 'lost') this.enter('lost');
    else this.hearer.changed();
  }

  private enter(phase: ConnectionState['phase']): void {
    this.state.phase = phase;
    this.state.sinceMs = performance.now();
    this.hearer.changed();
  }

  private drop(): void {
    const socket = this.socket;
    this.socket = null;
    this.pinged = null;
    this.state.bytesPerS = 0;
    if (socket && socket.readyState <= WebSocket.OPEN) socket.close();
  }

  private beat(): void {
    if (this.socket?.readyState !== WebSocket.OPEN) return;
    if (performance.now() - this.heardMs > silenceMs) {
      this.lose();
      return;
    }
    this.state.bytesPerS = this.bytes;
    this.bytes = 0;
    if (this.state.phase === 'live') this.ping();
    this.hearer.changed();
  }

  private ping(): void {
    if (this.pinged) return; // the answer to the last is still out: its time goes on
    const id = this.hearer.nextId();
    if (this.send({ type: 'ping', id })) this.pinged = { id, atMs: performance.now() };
  }
}
