// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Layer 10: what the newest pings heard. Fill for an echo, outline for silence, dashes for what was rejected. */
import type { PingRecord } from '../model/ping_store.ts';
import { withAlpha } from './palette.ts';
import { drawMark, type Pen } from './pen.ts';

export interface ConeLook { halfAngleOf: (ping: PingRecord) => number; alphaOf: (ping: PingRecord) => number }

const order: readonly PingRecord['outcome'][] = ['no_echo', 'too_close', 'echo', 'rejected'];
const sectorFromScale = 18;

/** The arc lies between the two sensors where one listens to another; seen from their middle it is nearly a circle. */
function source(p: PingRecord): { x: number; y: number; yaw: number } {
  if (p.tx === p.rx) return { x: p.txX, y: p.txY, yaw: p.txYaw };
  const yaw = Math.atan2(Math.sin(p.txYaw) + Math.sin(p.rxYaw), Math.cos(p.txYaw) + Math.cos(p.rxYaw));
  return { x: (p.txX + p.rxX) / 2, y: (p.txY + p.rxY) / 2, yaw };
}

export function drawCones(pen: Pen, pings: readonly PingRecord[], look: ConeLook): void {
  for (const outcome of order) for (const p of pings) if (p.outcome === outcome) drawCone(pen, p, look.halfAngleOf(p), look.alphaOf(p));
}

export function drawCone(pen: Pen, p: PingRecord, half: number, alpha: number): void {
  if (alpha <= 0) return;
  const { rgb } = pen.palette;
  const { x, y, yaw } = source(p);
  if (p.outcome === 'no_echo' || p.outcome === 'too_close') {
    if (!(p.trustedM > 0) || pen.s < sectorFromScale) return;
    pen.sector(x, y, yaw, half, p.trustedM);
    pen.stroke(withAlpha(rgb.none, 0.8 * alpha), 1);
  } else if (p.outcome === 'rejected') {
    drawRejected(pen, p, x, y, yaw, half, alpha);
  } else {
    drawEcho(pen, p, x, y, yaw, half, alpha);
  }
}

function drawEcho(pen: Pen, p: PingRecord, x: number, y: number, yaw: number, half: number, alpha: number): void {
  const { g, palette: { rgb, dark } } = pen;
  if (pen.s >= sectorFromScale) {
    const fill = g.createRadialGradient(pen.x(x), pen.y(y), 0, pen.x(x), pen.y(y), Math.max(1, p.rangeM * pen.s));
    fill.addColorStop(0, withAlpha(rgb.hit, 0.04 * alpha));
    fill.addColorStop(1, withAlpha(rgb.hit, (dark ? 0.3 : 0.22) * alpha));
    pen.sector(x, y, yaw, half, p.rangeM);
    g.fillStyle = fill;
    g.fill();
  }
  g.lineCap = 'round';
  g.beginPath();
  pen.arc(x, y, p.rangeM, yaw - half, yaw + half);
  pen.stroke(withAlpha(rgb.hit, alpha), 2.5);
  g.lineCap = 'butt';
  if (p.tx === p.rx) return;
  for (const [fromX, fromY] of [[p.txX, p.txY], [p.rxX, p.rxY]] as const) {
    g.beginPath();
    pen.move(fromX, fromY);
    pen.line(x + p.rangeM * Math.cos(yaw), y + p.rangeM * Math.sin(yaw));
    pen.stroke(withAlpha(rgb.hit, 0.6 * alpha), 1, [1, 3]);
  }
}

function drawRejected(pen: Pen, p: PingRecord, x: number, y: number, yaw: number, half: number, alpha: number): void {
  const range = p.rangeM > 0 ? p.rangeM : p.trustedM;
  if (!(range > 0)) return;
  const colour = withAlpha(pen.palette.rgb.rej, alpha);
  pen.sector(x, y, yaw, half, range);
  pen.stroke(colour, 1.75, [5, 4]);
  drawMark(pen.g, 3, pen.x(x + range * Math.cos(yaw)), pen.y(y + range * Math.sin(yaw)), 5, colour);
}

/** Arcs alone, of many pings: where echoes may have come from. */
export function drawArcs(pen: Pen, pings: readonly PingRecord[], halfAngleOf: (ping: PingRecord) => number): void {
  pen.g.beginPath();
  for (const p of pings) {
    if (p.outcome !== 'echo') continue;
    const { x, y, yaw } = source(p);
    const half = halfAngleOf(p);
    pen.move(x + p.rangeM * Math.cos(yaw + half), y + p.rangeM * Math.sin(yaw + half));
    pen.arc(x, y, p.rangeM, yaw - half, yaw + half);
  }
  pen.stroke(withAlpha(pen.palette.rgb.hit, 0.12), 1);
}

/** Distance in pixels from a place to the arc of an echo; infinite for what has none. */
export function arcDistancePx(p: PingRecord, half: number, x: number, y: number, s: number): number {
  if (p.outcome !== 'echo') return Number.POSITIVE_INFINITY;
  const from = source(p);
  const off = Math.atan2(y - from.y, x - from.x) - from.yaw;
  const bearing = Math.atan2(Math.sin(off), Math.cos(off));
  const nearest = from.yaw + Math.max(-half, Math.min(half, bearing));
  return s * Math.hypot(x - from.x - p.rangeM * Math.cos(nearest), y - from.y - p.rangeM * Math.sin(nearest));
}
