// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Writes what came over the wire into the model's stores, and tells who listens. */
import { appendScores, applyBins, emptyTimeline, seriesOf, timelineOf } from '../model/history.ts';
import type { Topic } from '../model/model.ts';
import { MapStore } from '../model/map_store.ts';
import type { Live } from '../model/live.ts';
import type { FromServer, Methods, Welcome } from '../protocol/messages.ts';
import { eachPoint, type Frame, frameKind, pairsOf, pingsOf, readFrame, tilesOf } from './frames.ts';

export class Receiver {
  /** Kinds and methods of which nothing came since the welcome: the first frame of each replaces what was before. */
  private welcomed = new Set<string>();

  /** `methodsOf`: that a question asked about. */
  constructor(private readonly live: Live, private readonly tell: (topic: Topic) => void, private readonly methodsOf: (question: number) => readonly string[]) {}

  message(message: FromServer): void {
    const { live } = this;
    switch (message.type) {
      case 'welcome': this.welcome(message); break;
      case 'history':
        live.timeline = timelineOf(message);
        live.scoreHistory = seriesOf(message);
        this.tell('scores');
        this.tell('timeline');
        break;
      case 'timeline': applyBins(live.timeline, message); this.tell('timeline'); break;
      case 'state': live.state = message; this.tell('state'); break;
      case 'plan': live.plan = message.strategy === '' ? null : message; this.tell('plan'); break;
      case 'counters': live.counters = message; this.tell('counters'); break;
      case 'methods': this.methods(message); break;
      case 'recompute':
        if (message.done >= message.total) live.recompute.delete(message.method);
        else live.recompute.set(message.method, message);
        this.tell('recompute');
        break;
      case 'scores':
        live.scores = message;
        appendScores(live.scoreHistory, message);
        this.tell('scores');
        break;
      case 'viewers': live.viewers = message; this.tell('viewers'); break;
      case 'drive_request': live.driveRequest = message; this.tell('drive_request'); break;
      case 'drive_lost': live.driveLost = message; this.tell('drive_lost'); break;
      case 'error': live.refused = message; this.tell('refused'); break;
      default: break; // pong and bye are the connection's, the rest are answers to questions
    }
  }

  frame(bytes: ArrayBuffer): void {
    const frame = readFrame(bytes);
    if (!frame) {
      console.error(`The server sent a frame of ${bytes.byteLength} bytes that is none.`);
      return;
    }
    if (frame.id !== 0) this.answer(frame);
    else if (frame.kind === frameKind.pings) this.pings(frame);
    else if (frame.kind === frameKind.laser) { this.live.laser = pairsOf(frame); this.tell('laser'); }
    else if (frame.kind === frameKind.path) this.path(frame);
    else this.map(frame);
  }

  private welcome(message: Welcome): void {
    const { live } = this;
    const before = live.welcome;
    if (before && before.version !== message.version) live.connection.versionDiffers = true;
    if (before && before.session !== message.session) {
      live.pings.clear();
      live.pathLength = 0;
      live.maps.clear();
      live.timeline = emptyTimeline();
      live.scoreHistory = new Map();
    }
    this.welcomed = new Set();
    live.welcome = message;
    live.plan = null;
    live.recompute.clear();
    this.tell('welcome');
  }

  private methods(message: Methods): void {
    const { live } = this;
    live.methods = message;
    const running = new Set(message.running.map((r) => r.method));
    for (const method of live.maps.keys()) if (!running.has(method)) live.maps.delete(method);
    for (const method of live.scoreHistory.keys()) if (!running.has(method)) live.scoreHistory.delete(method);
    for (const { method, name, grid } of message.running) {
      const map = live.maps.get(method) ?? new MapStore(method);
      map.name = name;
      map.grid = grid ? { cellM: grid.cell_m, x: grid.x_m, y: grid.y_m } : null;
      live.maps.set(method, map);
    }
    this.tell('methods');
    this.tell('map');
  }

  private first(key: string): boolean {
    if (this.welcomed.has(key)) return false;
    this.welcomed.add(key);
    return true;
  }

  private pings(frame: Frame): void {
    if (frame.reset) this.live.pings.clear();
    for (const ping of pingsOf(frame)) this.live.pings.add(ping);
    this.tell('pings');
  }

  private path(frame: Frame): void {
    const { live } = this;
    const isFirst = this.first('path');
    if (frame.reset || isFirst) live.pathLength = 0;
    live.appendPath(pairsOf(frame));
    this.tell('path');
  }

  private map(frame: Frame): void {
    const method = this.live.methods?.running[frame.method]?.method;
    const map = method === undefined ? undefined : this.live.maps.get(method);
    if (!map) return; // of a method that ended while the frame was under way
    const isFirst = this.first(`${frame.kind} ${map.method}`);
    write(frame, map, frame.reset || isFirst);
    this.tell('map');
  }

  private answer(frame: Frame): void {
    const store = this.live.answers.of(frame.id);
    if (frame.kind === frameKind.pings) {
      for (const ping of pingsOf(frame)) store.pings.push(ping);
    } else {
      const method = this.methodsOf(frame.id)[frame.method];
      if (method === undefined || (frame.kind !== frameKind.tiles && frame.kind !== frameKind.points)) return;
      const live = this.live.maps.get(method);
      const map = store.map(method, live?.name ?? method);
      map.grid ??= live?.grid ?? null;
      write(frame, map, frame.reset);
    }
    this.tell('map');
  }
}

function write(frame: Frame, map: MapStore, reset: boolean): void {
  if (frame.kind === frameKind.tiles) {
    if (reset) map.clearTiles();
    for (const { column, row, bytes } of tilesOf(frame)) map.setTile(column, row, bytes);
  } else {
    if (reset) map.clearPoints();
    eachPoint(frame, (point) => map.setPoint(point));
  }
}
