// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Layer 13 while a point is explained: the arcs behind it, where they cross, and how far off it may be. */
import type { Explanation, PingDetail } from '../protocol/messages.ts';
import type { Box } from './camera.ts';
import { drawWays } from './cones.ts';
import { arcOfDetail, type EchoArc, placeAt } from './echo_arc.ts';
import { withAlpha } from './palette.ts';
import { drawMark, type Pen } from './pen.ts';
import { drawGhost } from './robot.ts';
import { type MarkSlot, slotColour } from './slots.ts';

export const dimAlpha = 0.72;

interface Cone { arc: EchoArc; ping: PingDetail }

function coneOf(ping: PingDetail): Cone | null {
  const arc = arcOfDetail(ping);
  return arc.rangeM > 0 ? { arc, ping } : null;
}

/** From the sensor to the ends of the arc; from two, dotted. */
function edges(pen: Pen, { arc, ping }: Cone, colour: string): void {
  if (ping.tx !== ping.rx) {
    drawWays(pen, arc, [[ping.T_world_tx[0], ping.T_world_tx[1]], [ping.T_world_rx[0], ping.T_world_rx[1]]], colour);
    return;
  }
  pen.g.beginPath();
  for (const t of [-arc.half, arc.half]) {
    pen.move(arc.x, arc.y);
    pen.line(...placeAt(arc, t));
  }
  pen.stroke(colour, 1);
}

function drawArc(pen: Pen, { arc }: Cone, colour: string, width: number): void {
  pen.g.beginPath();
  pen.echo(arc);
  pen.stroke(colour, width);
}

function sensors(pen: Pen, { ping }: Cone, radiusPx: number, colour: string): void {
  pen.dot(ping.T_world_tx[0], ping.T_world_tx[1], radiusPx, colour);
  if (ping.tx !== ping.rx) pen.dot(ping.T_world_rx[0], ping.T_world_rx[1], radiusPx, colour);
}

/** Short strokes across the arc at both ends of the interval in which the point may lie. */
function bracket(pen: Pen, { arc }: Cone, t: number, bound: number): void {
  const reach = 8 / pen.s;
  for (const side of [-1, 1]) {
    const at = t + side * bound;
    const [x, y] = placeAt(arc, at);
    const [dx, dy] = [reach * Math.cos(arc.yaw + at), reach * Math.sin(arc.yaw + at)];
    pen.g.beginPath();
    pen.move(x - dx, y - dy);
    pen.line(x + dx, y + dy);
    pen.stroke(pen.palette.css.ink, 2);
  }
}

export function drawExplanation(pen: Pen, e: Explanation, hovered: number | null, slot: MarkSlot, robotRadiusM: number): void {
  const { g, palette: { rgb, css } } = pen;
  const own = e.own ? coneOf(e.own) : null;
  const cones = e.support.map((s) => coneOf(s.ping)).filter((c): c is Cone => c !== null && c.ping.ping !== e.own?.ping);
  for (const c of [...cones, ...(own ? [own] : [])]) drawGhost(pen, c.ping.T_world_robot[0], c.ping.T_world_robot[1], robotRadiusM);
  // The hovered one last, so that nothing lies over it.
  for (const c of [...cones].sort((a, b) => Number(a.ping.ping === hovered) - Number(b.ping.ping === hovered))) {
    const on = c.ping.ping === hovered;
    edges(pen, c, withAlpha(rgb.hit, on ? 0.6 : 0.18));
    if (on) {
      pen.sector(c.arc);
      g.fillStyle = withAlpha(rgb.hit, 0.1);
      g.fill();
    }
    drawArc(pen, c, withAlpha(rgb.hit, on ? 1 : 0.62), on ? 3 : 1.75);
    sensors(pen, c, on ? 3.5 : 2.5, css.hit);
  }
  const colour = slotColour[slot];
  if (own) {
    edges(pen, own, withAlpha(rgb[colour], 0.45));
    drawArc(pen, own, css[colour], 3);
    sensors(pen, own, 4, css[colour]);
  }
  for (const s of e.support) {
    if (s.x === null || s.y === null) continue;
    const on = s.ping.ping === hovered;
    pen.dot(s.x, s.y, on ? 5.5 : 4, css.surface);
    pen.stroke(css.hit, on ? 2.5 : 1.75);
  }
  if (own && e.arc && e.arc.bound_t !== null) bracket(pen, own, e.arc.t, e.arc.bound_t);
  if (e.kind === 'cell') return;
  drawMark(g, slot, pen.x(e.x), pen.y(e.y), 9, css.surface);
  drawMark(g, slot, pen.x(e.x), pen.y(e.y), 7, css[colour]);
}

/** The outlined cell of an explanation of cells. */
export function outlineCell(pen: Pen, x: number, y: number, cellM: number): void {
  const side = cellM * pen.s;
  const px = pen.x(x - cellM / 2);
  const py = pen.y(y + cellM / 2);
  for (const [colour, width] of [[pen.palette.css.surface, 5], [pen.palette.css.ink, 2.5]] as const) {
    pen.g.beginPath();
    pen.g.rect(px, py, side, side);
    pen.stroke(colour, width);
  }
}

/** Everything that an explanation speaks of. */
export function explanationBox(e: Explanation): Box {
  const box = { x0: e.x, y0: e.y, x1: e.x, y1: e.y };
  const add = (x: number, y: number): void => {
    box.x0 = Math.min(box.x0, x);
    box.x1 = Math.max(box.x1, x);
    box.y0 = Math.min(box.y0, y);
    box.y1 = Math.max(box.y1, y);
  };
  for (const ping of [...e.support.map((s) => s.ping), ...(e.own ? [e.own] : [])]) {
    const c = coneOf(ping);
    if (!c) continue;
    add(ping.T_world_tx[0], ping.T_world_tx[1]);
    add(ping.T_world_rx[0], ping.T_world_rx[1]);
    for (const t of [-c.arc.half, 0, c.arc.half]) add(...placeAt(c.arc, t));
  }
  return box;
}
