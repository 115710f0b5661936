// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Layer 10: what the newest pings heard. Fill for an echo, outline for silence, dashes for what was rejected. */
import type { PingRecord } from '../model/ping_store.ts';
import { arcOfRecord, distanceToArc, type EchoArc, type Place, placeAt } from './echo_arc.ts';
import { withAlpha } from './palette.ts';
import { drawMark, type Pen } from './pen.ts';

export interface ConeLook { halfAngleOf: (ping: PingRecord) => number; alphaOf: (ping: PingRecord) => number }

const order: readonly PingRecord['outcome'][] = ['no_echo', 'too_close', 'echo', 'rejected'];
const sectorFromScale = 18;

export function drawCones(pen: Pen, pings: readonly PingRecord[], look: ConeLook): void {
  for (const outcome of order) for (const p of pings) if (p.outcome === outcome) drawCone(pen, p, look.halfAngleOf(p), look.alphaOf(p));
}

export function drawCone(pen: Pen, p: PingRecord, half: number, alpha: number): void {
  if (alpha <= 0) return;
  const { rgb } = pen.palette;
  if (p.outcome === 'no_echo' || p.outcome === 'too_close') {
    if (!(p.trustedM > 0) || pen.s < sectorFromScale) return;
    pen.sector(arcOfRecord(p, p.trustedM, half));
    pen.stroke(withAlpha(rgb.none, 0.8 * alpha), 1);
  } else if (p.outcome === 'rejected') {
    drawRejected(pen, p, half, alpha);
  } else {
    drawEcho(pen, p, half, alpha);
  }
}

function drawEcho(pen: Pen, p: PingRecord, half: number, alpha: number): void {
  const { g, palette: { rgb, dark } } = pen;
  const arc = arcOfRecord(p, p.rangeM, half);
  if (pen.s >= sectorFromScale) {
    const [px, py] = [pen.x(arc.x), pen.y(arc.y)];
    const fill = g.createRadialGradient(px, py, 0, px, py, Math.max(1, p.rangeM * pen.s));
    fill.addColorStop(0, withAlpha(rgb.hit, 0.04 * alpha));
    fill.addColorStop(1, withAlpha(rgb.hit, (dark ? 0.3 : 0.22) * alpha));
    pen.sector(arc);
    g.fillStyle = fill;
    g.fill();
  }
  g.lineCap = 'round';
  g.beginPath();
  pen.echo(arc);
  pen.stroke(withAlpha(rgb.hit, alpha), 2.5);
  g.lineCap = 'butt';
  if (p.tx !== p.rx) drawWays(pen, arc, [[p.txX, p.txY], [p.rxX, p.rxY]], withAlpha(rgb.hit, 0.6 * alpha));
}

/** Both sensors, dotted to the ends of the arc between them. */
export function drawWays(pen: Pen, arc: EchoArc, sensors: readonly Place[], colour: string): void {
  pen.g.beginPath();
  for (const [fromX, fromY] of sensors) {
    for (const t of [-arc.half, arc.half]) {
      pen.move(fromX, fromY);
      pen.line(...placeAt(arc, t));
    }
  }
  pen.stroke(colour, 1, [1, 3]);
}

function drawRejected(pen: Pen, p: PingRecord, half: number, alpha: number): void {
  const range = p.rangeM > 0 ? p.rangeM : p.trustedM;
  if (!(range > 0)) return;
  const colour = withAlpha(pen.palette.rgb.rej, alpha);
  const arc = arcOfRecord(p, range, half);
  pen.sector(arc);
  pen.stroke(colour, 1.75, [5, 4]);
  const [x, y] = placeAt(arc, 0);
  drawMark(pen.g, 3, pen.x(x), pen.y(y), 5, colour);
}

/** Arcs alone, of many pings: where echoes may have come from. */
export function drawArcs(pen: Pen, pings: readonly PingRecord[], halfAngleOf: (ping: PingRecord) => number): void {
  pen.g.beginPath();
  for (const p of pings) {
    if (p.outcome !== 'echo') continue;
    const arc = arcOfRecord(p, p.rangeM, halfAngleOf(p));
    pen.move(...placeAt(arc, arc.half));
    pen.echo(arc);
  }
  pen.stroke(withAlpha(pen.palette.rgb.hit, 0.12), 1);
}

/** Distance in pixels from a place to the arc of an echo; infinite for what has none. */
export function arcDistancePx(p: PingRecord, half: number, x: number, y: number, s: number): number {
  return p.outcome === 'echo' ? s * distanceToArc(arcOfRecord(p, p.rangeM, half), x, y) : Number.POSITIVE_INFINITY;
}
