// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Layer 11: what a strategy has in mind. The graph it made is ink, what it plans has the robot's own colour; every kind has a shape of its own. */
import type { Plan } from '../protocol/messages.ts';
import { withAlpha } from './palette.ts';
import type { Pen } from './pen.ts';
import { drawTarget, type RobotPose } from './robot.ts';

const pathDash = [6, 5];
const nodePx = 4.5;
/** A robot is within the ellipse in 95 of 100 cases: this many standard deviations, in the plane. */
const ellipseDeviations = 2.448;
const leastEllipsePx = 3;

type Point = readonly [number, number];

export function drawPlan(pen: Pen, plan: Plan, from: RobotPose, robotRadiusM: number): void {
  for (const edge of plan.edges) {
    trace(pen, edge);
    halo(pen, pen.palette.css.ink2, 1.75);
  }
  const start: Point = [from.x, from.y];
  if (plan.path.length > 0) {
    trace(pen, [start, ...plan.path]);
    halo(pen, pen.palette.css.accent, 2, pathDash);
  }
  for (const { at, kind } of plan.nodes) if (kind === 'goal') drawTarget(pen, { x: at[0], y: at[1] }, robotRadiusM);
  for (const { at, kind } of plan.nodes) if (kind !== 'goal') drawNode(pen, at, kind);
  if (plan.estimate) drawEllipse(pen, plan.estimate);
}

function trace(pen: Pen, points: readonly Point[]): void {
  pen.g.beginPath();
  points.forEach(([x, y], i) => { if (i === 0) pen.move(x, y); else pen.line(x, y); });
}

/** The path that was traced, readable on walls and on free space. */
function halo(pen: Pen, colour: string, width: number, dash: number[] = []): void {
  const { g, palette } = pen;
  g.lineJoin = 'round';
  pen.stroke(withAlpha(palette.rgb.surface, 0.8), width + 2.5);
  pen.stroke(colour, width, dash);
  g.lineJoin = 'miter';
}

/** Meet point: disc; where an edge ends at a boundary: square; frontier: triangle; others: small ring. */
function drawNode(pen: Pen, [x, y]: Point, kind: string): void {
  const { g, palette: { css } } = pen;
  const [px, py] = [pen.x(x), pen.y(y)];
  g.beginPath();
  if (kind === 'boundary') g.rect(px - 0.85 * nodePx, py - 0.85 * nodePx, 1.7 * nodePx, 1.7 * nodePx);
  else if (kind === 'frontier') triangle(g, px, py, 1.35 * nodePx);
  else g.arc(px, py, kind === 'meet' ? nodePx : 0.7 * nodePx, 0, 2 * Math.PI);
  g.fillStyle = kind === 'meet' ? css.ink : css.surface;
  if (kind === 'meet') {
    pen.stroke(css.surface, 3);
    g.fill();
    return;
  }
  pen.stroke(css.surface, 4.5);
  g.fill();
  pen.stroke(kind === 'frontier' ? css.accent : css.ink, 2);
}

function triangle(g: CanvasRenderingContext2D, px: number, py: number, r: number): void {
  g.moveTo(px, py - r);
  g.lineTo(px + 0.87 * r, py + 0.5 * r);
  g.lineTo(px - 0.87 * r, py + 0.5 * r);
  g.closePath();
}

function drawEllipse(pen: Pen, { pose, deviation_m: [along, across] }: NonNullable<Plan['estimate']>): void {
  const { g, palette } = pen;
  const radius = (deviationM: number): number => Math.max(leastEllipsePx, ellipseDeviations * Math.abs(deviationM) * pen.s);
  g.beginPath();
  g.ellipse(pen.x(pose[0]), pen.y(pose[1]), radius(along), radius(across), -pose[2], 0, 2 * Math.PI);
  g.fillStyle = withAlpha(palette.rgb.accent, 0.12);
  g.fill();
  pen.stroke(palette.css.accent, 1.5);
}
