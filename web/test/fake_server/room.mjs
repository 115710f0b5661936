// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** The simulated room: drives, fires, maps, and keeps what every viewer is told. */
import { Maps } from './mapping.mjs';
import { duration, fire, rejections, sonar, speed, tourPose, walls } from './world.mjs';

const pingS = 0.04;
const deadManS = 0.5;
const number = (name, unit, value, min, max, doc) => ({ name, kind: 'real', unit, default: value, min, max, choices: [], doc, source: '[Barshan07]' });
const catalogue = [
  ['atm', 'Arc-transversal median', 'Arc median', 'needs steep crossings, and then lands on the wall; where the robot only drove straight it has few points.', [number('min_angle', 'deg', 13, 1, 60, 'Least angle at which arcs must cross.')]],
  ['evidence', 'Occupancy grid of evidence', 'Occupancy grid', 'smears along arcs until several views agree.', [number('occupied_peak', '', 0.85, 0.5, 0.99, 'Chance on the arc.'), { name: 'rule', kind: 'choice', unit: '', default: 'bayes', min: null, max: null, choices: ['bayes', 'max'], doc: 'How readings are combined.', source: '' }, { name: 'silence', kind: 'boolean', unit: '', default: true, min: null, max: null, choices: [], doc: 'Whether no echo counts.', source: '' }]],
  ['carve', 'Arc carving', 'Arc carving', 'drops what later pings prove empty; bounds shrink as it drives.', [number('guard', 'm', 0.025, 0, 0.05, 'Part of a range that is not trusted.')]],
  ['centerline', 'Centerline', 'Centerline', 'puts every echo on the beam axis, which narrows doors and frays corners.', []],
];
export const methodNames = catalogue.map(([name]) => name);

export class Room {
  maps = new Maps();
  t = 0;
  driven = 0;
  mode = 'tour';
  pose = tourPose(0);
  v = 0;
  w = 0;
  wish = { v: 0, w: 0, at: -1 };
  driver = null;
  stoppedBy = null;
  path = [];
  scores = methodNames.map((method) => ({ method, t: [], mae_m: [] }));
  bins = { echoes: [], no_echoes: [], rejected: [] };
  off = new Set();
  options = Object.fromEntries(catalogue.map(([name, , , , options]) => [name, Object.fromEntries(options.map((o) => [o.name, o.default]))]));
  rejected = {};
  #fired = 0;

  advance(seconds) {
    for (const end = this.t + seconds; this.t + pingS <= end + 1e-9;) {
      this.t += pingS;
      this.#move(pingS);
      const k = (++this.#fired * 7) % sonar.count;
      if (!this.off.has(k)) this.#hear(fire(this.t, k, this.pose));
      if (this.#fired % 3 === 0) this.path.push([this.pose[0], this.pose[1]]);
      if (this.#fired % 75 === 0) this.#score();
    }
  }

  #move(dt) {
    if (this.mode === 'tour') {
      if (this.driven >= duration) { this.mode = 'stand'; return; }
      this.driven += dt;
      const next = tourPose(this.driven);
      this.v = speed;
      this.w = Math.atan2(Math.sin(next[2] - this.pose[2]), Math.cos(next[2] - this.pose[2])) / dt;
      this.pose = next;
      return;
    }
    if (this.mode === 'drive' && this.t - this.wish.at > deadManS) this.wish = { v: 0, w: 0, at: this.t };
    const wish = this.mode === 'drive' ? this.wish : { v: 0, w: 0 };
    this.v += Math.max(-1.5 * dt, Math.min(1.5 * dt, wish.v - this.v));
    this.w = wish.w;
    this.pose = [this.pose[0] + this.v * dt * Math.cos(this.pose[2]), this.pose[1] + this.v * dt * Math.sin(this.pose[2]), this.pose[2] + this.w * dt];
  }

  #hear(p) {
    this.maps.add(p);
    const bin = Math.floor(p.t);
    const kind = ['no_echoes', 'echoes', 'rejected', 'rejected'][p.outcome];
    for (const list of Object.values(this.bins)) while (list.length <= bin) list.push(0);
    this.bins[kind][bin]++;
    if (p.outcome === 3) this.rejected[rejections[p.reason]] = (this.rejected[rejections[p.reason]] ?? 0) + 1;
  }

  #score() {
    for (const s of this.scores) {
      s.t.push(this.t);
      s.mae_m.push(this.maps.score(s.method).mae);
    }
  }

  welcome(viewer, mayDrive) {
    const sensors = Array.from({ length: sonar.count }, (_, id) => {
      const yaw = (id * Math.PI) / 8;
      return { id, T_robot_sensor: [sonar.radius * Math.cos(yaw), sonar.radius * Math.sin(yaw), yaw], beam_width: 2 * sonar.half, range_min_m: 0.15, range_max_m: sonar.maxM, rate_hz: 1.56 };
    });
    return {
      type: 'welcome', protocol: 1, version: '0.0-fake', session: 'fake', you: { viewer, name: `Viewer ${viewer}`, may_drive: mayDrive },
      source: { room: 'main', kind: 'scene', name: 'rooms', title: 'Rooms and corridor', drivable: true, has_truth: true, has_laser: false, duration_s: null, walls },
      robot: { name: 'round', radius_m: sonar.radius, sensors },
      catalogue: catalogue.map(([name, title, short, look, options]) => ({ name, title, short, summary: title, source: '', options, look })),
      modes: ['stand', 'tour', 'drive', 'goto'], scenes: [{ name: 'rooms', title: 'Rooms and corridor' }, { name: 'hallway', title: 'A hallway' }],
      rejections: rejections.map((name) => ({ name, explanation: `Rejected: ${name}.`, remedy: 'Check how the sensors are mounted.' })), labels: methodNames,
      limits: { upload_bytes: 512e6, speed_m_s: 0.5, turn_rate: 1.5, dead_man_s: deadManS, stop_deceleration_m_s2: 1.5 },
    };
  }

  methods() {
    return { type: 'methods', running: catalogue.map(([method, , short]) => ({ method, name: method, label: short, options: this.options[method], state: 'ok', reason: '', grid: method === 'evidence' ? { cell_m: 0.05, x_m: 0, y_m: 0 } : null, points: method !== 'evidence' })) };
  }

  history() { return { type: 'history', bin_s: 1, ...structuredClone(this.bins), scores: structuredClone(this.scores) }; }

  state(viewers) {
    const pose = [...this.pose];
    return {
      type: 'state', tick: Math.round(10 * this.t), t: this.t, mono_us: Math.round(1000 * performance.now()), pose, true_pose: pose, v: this.v, w: this.w,
      mode: this.mode, reason: this.stoppedBy ? 'stopped' : '', goal: null, driver: this.driver, watchers: viewers, limit_m_s: 0.5, limited_by: 'none', free_ahead_m: 1.4,
      stopped_by: this.stoppedBy, playing: true, speed: 1, pings: this.maps.pings.length, drive_seq: null, drive_mono_us: null, distance_m: this.driven * speed,
    };
  }

  counters() {
    const { pings } = this.maps;
    const of = (list, outcome) => list.filter((p) => p.outcome === outcome).length;
    const sensors = Array.from({ length: sonar.count }, (_, id) => {
      const own = pings.filter((p) => p.k === id);
      const rejected = {};
      for (const p of own) if (p.outcome === 3) rejected[rejections[p.reason]] = (rejected[rejections[p.reason]] ?? 0) + 1;
      return { id, echoes: of(own, 1), no_echoes: of(own, 0), too_close: 0, rejected, rejected_last_minute: of(own.filter((p) => this.t - p.t < 60), 3), rate_hz: this.off.has(id) ? 0 : 1.56, on: !this.off.has(id) };
    });
    return {
      type: 'counters', pings: pings.length, echoes: of(pings, 1), no_echoes: of(pings, 0), too_close: 0, waiting: 0, rejected: this.rejected, rejected_odometry: {}, sensors,
      log: { state: 'on', bytes: 200 * pings.length, message: '' }, dropped: 0,
    };
  }

  scoresNow() {
    return {
      type: 'scores', t: this.t, reason: '', methods: methodNames.map((method) => {
        const { points, mae, p95 } = this.maps.score(method);
        const bounds = method === 'evidence' ? [] : this.maps.points[method].records.filter(Boolean).map((r) => r.bound).sort((a, b) => a - b);
        return { method, points, bound_m: bounds[bounds.length >> 1] ?? null, mae_m: mae, p95_m: p95, found: Math.min(1, points / 3000), cpu_ms_per_ping: 0.05 };
      }),
    };
  }
}
