// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Drawing on a 2-D canvas in world metres. */
import type { Camera } from '../model/model.ts';
import { type Area, pixelOf } from './camera.ts';
import { eccentric, type EchoArc } from './echo_arc.ts';
import type { Palette } from './palette.ts';
import type { MarkSlot } from './slots.ts';

export class Pen {
  readonly s: number;

  constructor(readonly g: CanvasRenderingContext2D, readonly camera: Camera, readonly area: Area, readonly palette: Palette) { this.s = camera.s; }

  x(x: number): number { return pixelOf(this.camera, this.area, x, 0).px; }
  y(y: number): number { return pixelOf(this.camera, this.area, 0, y).py; }

  move(x: number, y: number): void { this.g.moveTo(this.x(x), this.y(y)); }
  line(x: number, y: number): void { this.g.lineTo(this.x(x), this.y(y)); }

  stroke(style: string, width: number, dash: number[] = []): void {
    this.g.strokeStyle = style;
    this.g.lineWidth = width;
    this.g.setLineDash(dash);
    this.g.stroke();
    if (dash.length > 0) this.g.setLineDash([]);
  }

  /** Adds an arc to the path, from world angle `from` on to `to`. */
  arc(x: number, y: number, radiusM: number, from: number, to: number): void {
    this.g.arc(this.x(x), this.y(y), Math.max(0, radiusM * this.s), -to, -from);
  }

  /** Adds the piece of an echo's arc from `from` to `to` off its axis, circle or ellipse. */
  echo(arc: EchoArc, from = -arc.half, to = arc.half): void {
    if (arc.rangeM === arc.semiMinorM) { this.arc(arc.x, arc.y, arc.rangeM, arc.yaw + from, arc.yaw + to); return; }
    const [major, minor] = [Math.max(0, arc.rangeM * this.s), Math.max(0, arc.semiMinorM * this.s)];
    this.g.ellipse(this.x(arc.x), this.y(arc.y), major, minor, -arc.focal, -eccentric(arc, to), -eccentric(arc, from));
  }

  /** Outline of what an echo's beam covers: centre, edge, arc, edge. */
  sector(arc: EchoArc): void {
    this.g.beginPath();
    this.move(arc.x, arc.y);
    this.echo(arc);
    this.g.closePath();
  }

  dot(x: number, y: number, radiusPx: number, fill: string): void {
    this.g.beginPath();
    this.g.arc(this.x(x), this.y(y), radiusPx, 0, 2 * Math.PI);
    this.g.fillStyle = fill;
    this.g.fill();
  }
}

/** The mark of a slot: diamond, disc, diagonal cross, open square. */
export function drawMark(g: CanvasRenderingContext2D, slot: MarkSlot, px: number, py: number, r: number, colour: string, open = false): void {
  g.fillStyle = g.strokeStyle = colour;
  g.beginPath();
  if (slot === 1) {
    const q = 1.25 * r;
    g.moveTo(px, py - q);
    g.lineTo(px + q, py);
    g.lineTo(px, py + q);
    g.lineTo(px - q, py);
    g.closePath();
  } else if (slot === 2) {
    g.arc(px, py, r, 0, 2 * Math.PI);
  } else if (slot === 3) {
    g.moveTo(px - r, py - r);
    g.lineTo(px + r, py + r);
    g.moveTo(px - r, py + r);
    g.lineTo(px + r, py - r);
  } else {
    g.rect(px - 0.85 * r, py - 0.85 * r, 1.7 * r, 1.7 * r);
  }
  g.lineWidth = slot === 3 ? Math.max(1.1, 0.44 * r) : slot === 4 ? Math.max(0.9, 0.32 * r) : 1;
  if (slot >= 3 || open) g.stroke();
  else g.fill();
}
