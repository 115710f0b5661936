// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Layer 13 while a point is explained: the arcs behind it, where they cross, and how far off it may be. */
import type { Explanation, PingDetail } from '../protocol/messages.ts';
import type { Box } from './camera.ts';
import { withAlpha } from './palette.ts';
import { drawMark, type Pen } from './pen.ts';
import { drawGhost } from './robot.ts';
import { type MarkSlot, slotColour } from './slots.ts';

export const dimAlpha = 0.72;

interface Cone { x: number; y: number; yaw: number; r: number; half: number; ping: PingDetail }

function coneOf(ping: PingDetail): Cone | null {
  const r = ping.range_m ?? ping.trusted_range_m;
  if (!(r > 0)) return null;
  const [x, y, yaw] = ping.T_world_tx;
  if (ping.tx === ping.rx) return { x, y, yaw, r, half: ping.beam_width / 2, ping };
  const [x2, y2, yaw2] = ping.T_world_rx;
  const middle = Math.atan2(Math.sin(yaw) + Math.sin(yaw2), Math.cos(yaw) + Math.cos(yaw2));
  return { x: (x + x2) / 2, y: (y + y2) / 2, yaw: middle, r, half: ping.beam_width / 2, ping };
}

function edges(pen: Pen, c: Cone, colour: string): void {
  pen.g.beginPath();
  for (const side of [-1, 1]) {
    pen.move(c.x, c.y);
    pen.line(c.x + c.r * Math.cos(c.yaw + side * c.half), c.y + c.r * Math.sin(c.yaw + side * c.half));
  }
  pen.stroke(colour, 1);
}

function arc(pen: Pen, c: Cone, colour: string, width: number): void {
  pen.g.beginPath();
  pen.arc(c.x, c.y, c.r, c.yaw - c.half, c.yaw + c.half);
  pen.stroke(colour, width);
}

/** Short strokes across the arc at both ends of the interval in which the point may lie. */
function bracket(pen: Pen, own: Cone, t: number, bound: number): void {
  const reach = 8 / pen.s;
  for (const side of [-1, 1]) {
    const a = own.yaw + t + side * bound;
    pen.g.beginPath();
    pen.move(own.x + (own.r - reach) * Math.cos(a), own.y + (own.r - reach) * Math.sin(a));
    pen.line(own.x + (own.r + reach) * Math.cos(a), own.y + (own.r + reach) * Math.sin(a));
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
      pen.sector(c.x, c.y, c.yaw, c.half, c.r);
      g.fillStyle = withAlpha(rgb.hit, 0.1);
      g.fill();
    }
    arc(pen, c, withAlpha(rgb.hit, on ? 1 : 0.62), on ? 3 : 1.75);
    pen.dot(c.x, c.y, on ? 3.5 : 2.5, css.hit);
  }
  const colour = slotColour[slot];
  if (own) {
    edges(pen, own, withAlpha(rgb[colour], 0.45));
    arc(pen, own, css[colour], 3);
    pen.dot(own.x, own.y, 4, css[colour]);
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
    add(c.x, c.y);
    for (const t of [-c.half, 0, c.half]) add(c.x + c.r * Math.cos(c.yaw + t), c.y + c.r * Math.sin(c.yaw + t));
  }
  return box;
}
