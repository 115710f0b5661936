// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** One connection: what it is sent, and what it may ask. */
import { explain, step } from './answers.mjs';
import { pathFrame, pingFrame, pointFrame, tileFrame } from './frames.mjs';
import { Maps } from './mapping.mjs';
import { methodNames } from './room.mjs';

const newest = 2000;

export class Viewer {
  sent = { pings: 0, path: 0, tiles: -1, points: {} };
  mayDrive = false;
  greeted = false;

  constructor(socket, id, room, others, token) {
    Object.assign(this, { socket, id, room, others, token, name: `Viewer ${id}` });
    socket.on('message', (data, binary) => { if (!binary) this.hear(JSON.parse(data.toString())); });
  }

  say(message) { this.socket.send(JSON.stringify(message)); }

  refuse(id, message) { this.say({ type: 'error', id: id ?? null, code: 'refused', message, remedy: 'Look at the message.' }); }

  hear(m) {
    const { room } = this;
    const act = {
      hello: () => this.greet(m), ping: () => this.say({ type: 'pong', id: m.id, mono_us: Math.round(1000 * performance.now()) }),
      stop: () => { room.mode = 'stand'; room.wish = { v: 0, w: 0, at: room.t }; room.v = 0; room.stoppedBy = { who: 'viewer', viewer: this.id, name: this.name }; },
      explain: () => this.answer(m, explain(room.maps, m)), step: () => this.step(m),
      pings: () => { this.socket.send(pingFrame(room.maps.pings.slice(m.from, m.from + m.count), m.id)); this.say({ type: 'pings_end', id: m.id }); },
      snapshot: () => this.snapshot(m), subscribe: () => {},
      drive: () => { if (room.driver === this.id) Object.assign(room, { mode: 'drive', wish: { v: m.v, w: m.w, at: room.t }, stoppedBy: null }); else this.refuse(null, 'Someone else drives.'); },
    }[m.type];
    if (act) act();
    else if (!this.mayDrive) this.refuse(m.id, 'This needs the token.');
    else this.change(m);
  }

  change(m) {
    const { room } = this;
    if (m.type === 'take') {
      const driver = [...this.others].find((v) => v.id === room.driver);
      if (!driver) room.driver = this.id;
      else { this.asking = true; driver.say({ type: 'drive_request', viewer: this.id, name: this.name, timeout_s: 20 }); }
    } else if (m.type === 'release') room.driver = m.to ?? null;
    else if (m.type === 'answer') {
      const asker = [...this.others].find((v) => v.asking);
      if (!asker) return;
      asker.asking = false;
      if (m.accept) { room.driver = asker.id; this.say({ type: 'drive_lost', reason: 'handed_over' }); }
      else asker.say({ type: 'drive_lost', reason: 'kept' });
    } else if (m.type === 'mode') Object.assign(room, { mode: m.mode, stoppedBy: null });
    else if (m.type === 'sensor') room.off[m.on ? 'delete' : 'add'](m.sensor);
    else if (m.type === 'options') { Object.assign(room.options[m.method] ?? {}, m.options); for (const v of this.others) v.say(room.methods()); }
    else if (m.type === 'open') this.say({ type: 'opened', id: m.id, room: 'main' });
    for (const v of this.others) v.tellViewers();
  }

  answer(m, found) { if (found) this.say(found); else this.refuse(m.id, 'There is no such point or ping.'); }

  greet(m) {
    this.mayDrive = m.token === this.token;
    this.greeted = true;
    this.sent.pings = Math.max(0, this.room.maps.pings.length - newest);
    this.say(this.room.welcome(this.id, this.mayDrive));
    this.say(this.room.methods());
    this.say(this.room.history());
    for (const v of this.others) v.tellViewers();
    this.everySecond();
    this.update();
  }

  tellViewers() {
    if (this.greeted) this.say({ type: 'viewers', viewers: [...this.others].map((v) => ({ viewer: v.id, name: v.name, driver: v.id === this.room.driver, asking: v.asking === true })) });
  }

  /** Ten times a second: deltas since the last. */
  update() {
    if (!this.greeted || this.socket.bufferedAmount > 1e6) return;
    const { room, sent } = this;
    const { maps } = room;
    this.say(room.state(this.others.size));
    if (sent.pings < maps.pings.length) this.socket.send(pingFrame(maps.pings.slice(sent.pings)));
    if (sent.path < room.path.length) this.socket.send(pathFrame(room.path.slice(sent.path), sent.path === 0));
    const tiles = [...maps.cells.values()].filter((tile) => tile.sequence > sent.tiles);
    if (tiles.length) this.socket.send(tileFrame(methodNames.indexOf('evidence'), tiles, sent.tiles < 0, maps.sequence));
    for (const [method, points] of Object.entries(maps.points)) {
      const slots = points.since(sent.points[method] ?? -1);
      if (slots.length) this.socket.send(pointFrame(methodNames.indexOf(method), slots, points.records, sent.points[method] === undefined, points.sequence));
      sent.points[method] = points.sequence;
    }
    Object.assign(sent, { pings: maps.pings.length, path: room.path.length, tiles: maps.sequence });
  }

  everySecond() {
    if (!this.greeted) return;
    const { room } = this;
    this.say(room.counters());
    this.say(room.scoresNow());
    const first = Math.max(0, room.bins.echoes.length - 2);
    this.say({ type: 'timeline', first, echoes: room.bins.echoes.slice(first), no_echoes: room.bins.no_echoes.slice(first), rejected: room.bins.rejected.slice(first) });
  }

  /** The maps of the first `count` pings, built anew. */
  past(count) {
    const maps = new Maps();
    for (const p of this.room.maps.pings.slice(0, count)) maps.add({ ...p });
    return maps;
  }

  sendMaps(maps, id, methods) {
    for (const [index, method] of methods.entries()) {
      if (method === 'evidence') this.socket.send(tileFrame(index, [...maps.cells.values()], true, maps.sequence, id));
      else if (maps.points[method]) this.socket.send(pointFrame(index, maps.points[method].since(-1), maps.points[method].records, true, 0, id));
    }
  }

  step(m) {
    const earlier = this.past(m.ping);
    this.sendMaps(earlier, m.id, [m.method]);
    this.answer(m, step(this.room.maps, earlier, m));
  }

  snapshot({ id, t, methods }) {
    const { pings } = this.room.maps;
    const count = pings.filter((p) => p.t <= t).length;
    this.sendMaps(this.past(count), id, methods);
    this.say({ type: 'snapshot_end', id, t, pings: count, pose: pings[count - 1]?.pose ?? null });
  }
}
