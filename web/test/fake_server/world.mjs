// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** A made-up flat, a robot driving through it, and its sixteen sonars. Deterministic. */
const degree = Math.PI / 180;
export const wrap = (a) => Math.atan2(Math.sin(a), Math.cos(a));

let seed = 20260;
export function random() {
  seed = (seed + 0x6d2b79f5) | 0;
  let t = Math.imul(seed ^ (seed >>> 15), 1 | seed);
  t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
  return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
}
const gauss = () => Math.sqrt(-2 * Math.log(1 - random())) * Math.cos(2 * Math.PI * random());

const [width, height, thick] = [15, 9.6, 0.14];
const rectangles = [
  [-thick, -thick, width + thick, 0], [-thick, height, width + thick, height + thick], [-thick, 0, 0, height], [width, 0, width + thick, height],
  [0, 3.8, 2.6, 3.94], [3.55, 3.8, 9.4, 3.94], [10.4, 3.8, width, 3.94],
  [0, 5.5, 1.8, 5.64], [2.72, 5.5, 7.0, 5.64], [7.95, 5.5, 12.2, 5.64], [13.1, 5.5, width, 5.64],
  [4.9, 5.64, 5.04, height], [10.2, 5.64, 10.34, height], [6.2, 0, 6.34, 3.8],
  [0.5, 0.45, 1.75, 1.05], [4.75, 2.75, 5.6, 3.3], [5.55, 8.75, 6.9, 9.3], [9.35, 7.1, 9.85, 8.4], [0.35, 6.3, 0.8, 7.6],
  [12.5, 0.5, 14.1, 1.2], [10.8, 0.75, 11.4, 1.35], [13.9, 8.2, 14.6, 8.9], [11.0, 8.4, 12.2, 8.9], [14.3, 3.94, width, 4.3],
];
const pillars = [[4.3, 1.2, 0.24], [8.3, 1.25, 0.22], [11.9, 7.0, 0.2], [3.3, 9.0, 0.2]];

/** Closed polylines. */
export const walls = [
  ...rectangles.map(([a, b, c, d]) => [[a, b], [c, b], [c, d], [a, d], [a, b]]),
  ...pillars.map(([x, y, r]) => Array.from({ length: 19 }, (_, i) => [x + r * Math.cos((i * Math.PI) / 9), y + r * Math.sin((i * Math.PI) / 9)])),
];
const segments = walls.flatMap((wall) => wall.slice(1).map((to, i) => [...wall[i], ...to]));
const corners = rectangles.flatMap(([a, b, c, d]) => [[a, b], [c, b], [c, d], [a, d]]);

function cast(ox, oy, dx, dy) {
  let best = Infinity;
  let hit = null;
  for (const s of segments) {
    const [ex, ey] = [s[2] - s[0], s[3] - s[1]];
    const den = dx * ey - dy * ex;
    if (Math.abs(den) < 1e-9) continue;
    const [qx, qy] = [s[0] - ox, s[1] - oy];
    const t = (qx * ey - qy * ex) / den;
    const u = (qx * dy - qy * dx) / den;
    if (t > 1e-4 && t < best && u >= 0 && u <= 1) {
      best = t;
      hit = s;
    }
  }
  if (!hit) return null;
  const length = Math.hypot(hit[2] - hit[0], hit[3] - hit[1]);
  const cosine = Math.abs(((hit[3] - hit[1]) * dx - (hit[2] - hit[0]) * dy) / length);
  return { t: best, cosine };
}

export function wallDistance(x, y) {
  let best = Infinity;
  for (const s of segments) {
    const [ex, ey] = [s[2] - s[0], s[3] - s[1]];
    const u = Math.max(0, Math.min(1, ((x - s[0]) * ex + (y - s[1]) * ey) / (ex * ex + ey * ey)));
    best = Math.min(best, Math.hypot(x - s[0] - u * ex, y - s[1] - u * ey));
  }
  return best;
}

/** Corners of the tour, cut thrice so that it is smooth. */
let tour = [
  [1.3, 2.1], [3.05, 2.2], [4.0, 2.3], [3.6, 2.9], [3.07, 3.4], [3.07, 4.72], [1.3, 4.75], [2.26, 4.75], [2.26, 6.4], [1.6, 7.5], [2.2, 8.2],
  [3.9, 8.1], [4.0, 6.8], [2.4, 6.4], [2.26, 4.72], [5.2, 4.72], [7.47, 4.72], [7.47, 6.5], [6.1, 7.0], [6.2, 8.0], [8.3, 8.1], [8.6, 6.7],
  [7.47, 6.4], [7.47, 4.72], [9.9, 4.72], [9.9, 2.9], [7.5, 2.6], [7.2, 1.2], [7.5, 2.6], [9.8, 2.3], [12.6, 2.4], [13.6, 2.6], [12.0, 2.7],
  [9.9, 2.9], [9.9, 4.72], [12.65, 4.72], [12.65, 6.6], [13.6, 7.4], [12.7, 7.6], [11.2, 7.6], [11, 6.4], [12.65, 6.2],
];
for (let k = 0; k < 3; k++) {
  const cut = tour.slice(1).flatMap((b, i) => {
    const a = tour[i];
    return [[0.75 * a[0] + 0.25 * b[0], 0.75 * a[1] + 0.25 * b[1]], [0.25 * a[0] + 0.75 * b[0], 0.25 * a[1] + 0.75 * b[1]]];
  });
  tour = [tour[0], ...cut, tour.at(-1)];
}
const travelled = [0];
for (let i = 1; i < tour.length; i++) travelled.push(travelled[i - 1] + Math.hypot(tour[i][0] - tour[i - 1][0], tour[i][1] - tour[i - 1][1]));
export const speed = 0.3;
export const duration = travelled.at(-1) / speed - 1;

function along(distance) {
  const d = Math.max(0, Math.min(travelled.at(-1) - 1e-6, distance));
  const i = travelled.findIndex((t, k) => t <= d && (travelled[k + 1] ?? Infinity) > d);
  const u = (d - travelled[i]) / (travelled[i + 1] - travelled[i]);
  return [tour[i][0] + u * (tour[i + 1][0] - tour[i][0]), tour[i][1] + u * (tour[i + 1][1] - tour[i][1])];
}

/** Pose on the tour at a time of driving. */
export function tourPose(t) {
  const [x, y] = along(t * speed);
  const [a, b] = [along(t * speed - 0.12), along(t * speed + 0.16)];
  return [x, y, Math.atan2(b[1] - a[1], b[0] - a[0])];
}

export const sonar = { count: 16, radius: 0.2, half: 12.5 * degree, maxM: 4, trustedM: 1.6, quantum: 0.01 };
export const rejections = ['cross-talk', 'range jump', 'too close'];

/** One ping of sensor k from a pose. */
export function fire(t, k, pose) {
  const yaw = wrap(pose[2] + k * 22.5 * degree);
  const [x, y] = [pose[0] + sonar.radius * Math.cos(yaw), pose[1] + sonar.radius * Math.sin(yaw)];
  let range = Infinity;
  for (let i = -13; i <= 13; i++) {
    const off = (i / 13) * sonar.half;
    const [dx, dy] = [Math.cos(yaw + off), Math.sin(yaw + off)];
    const hit = cast(x, y, dx, dy);
    if (!hit) continue;
    const beam = (1 - (off / sonar.half) ** 2) ** 2;
    const angle = Math.acos(Math.min(1, hit.cosine));
    let amplitude = beam * (Math.exp(-((angle / (7 * degree)) ** 2)) + 0.05 * hit.cosine);
    const [hx, hy] = [x + hit.t * dx, y + hit.t * dy];
    for (const c of corners) if (Math.abs(c[0] - hx) < 0.05 && Math.abs(c[1] - hy) < 0.05) amplitude += 0.45 * beam;
    if (amplitude * Math.exp(-0.16 * hit.t) / Math.sqrt(Math.max(0.6, hit.t)) > 0.045) range = Math.min(range, hit.t);
  }
  let outcome = range > sonar.maxM ? 0 : 1;
  let reason = 0;
  if (random() < 0.013) [outcome, range, reason] = [3, 0.5 + 3 * random(), 0];
  if (outcome !== 0) range = Math.max(0.06, Math.round((range + 0.006 * gauss()) / sonar.quantum) * sonar.quantum);
  if (outcome === 1 && range < 0.15) [outcome, reason] = [3, 2];
  return { t, k, x, y, yaw, range: outcome === 0 ? NaN : range, outcome, reason, pose: [...pose] };
}
