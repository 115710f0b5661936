// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Layers 11 and 12: the robot, where it goes, and where it will be. */
import { withAlpha } from './palette.ts';
import type { Pen } from './pen.ts';

export interface RobotPose { x: number; y: number; yaw: number }

const leastPx = 9;

export function drawRobot(pen: Pen, pose: RobotPose, radiusM: number): void {
  const { g, palette } = pen;
  const r = Math.max(leastPx, radiusM * pen.s);
  const [px, py] = [pen.x(pose.x), pen.y(pose.y)];
  g.beginPath();
  g.arc(px, py, r, 0, 2 * Math.PI);
  g.fillStyle = palette.css.surface;
  g.fill();
  pen.stroke(palette.css.ink, 2);
  // The arrow grows slower than the body, so that a robot seen from near is no wall of colour.
  const q = r < 24 ? r : 24 + 0.35 * (r - 24);
  const [c, s] = [Math.cos(pose.yaw), -Math.sin(pose.yaw)];
  g.beginPath();
  g.moveTo(px + 0.68 * c * q, py + 0.68 * s * q);
  g.lineTo(px - 0.42 * c * q - 0.46 * s * q, py - 0.42 * s * q + 0.46 * c * q);
  g.lineTo(px - 0.2 * c * q, py - 0.2 * s * q);
  g.lineTo(px - 0.42 * c * q + 0.46 * s * q, py - 0.42 * s * q - 0.46 * c * q);
  g.closePath();
  g.fillStyle = palette.css.accent;
  g.fill();
}

export function drawGhost(pen: Pen, x: number, y: number, radiusM: number): void {
  pen.g.beginPath();
  pen.g.arc(pen.x(x), pen.y(y), Math.max(leastPx, radiusM * pen.s), 0, 2 * Math.PI);
  pen.stroke(withAlpha(pen.palette.rgb.ink3, 0.9), 1);
}

export function drawGoal(pen: Pen, from: RobotPose, goal: { x: number; y: number }, radiusM: number): void {
  pen.g.beginPath();
  pen.move(from.x, from.y);
  pen.line(goal.x, goal.y);
  pen.stroke(pen.palette.css.accent, 2, [6, 5]);
  drawTarget(pen, goal, radiusM);
}

/** Where the robot is to stand. */
export function drawTarget(pen: Pen, goal: { x: number; y: number }, radiusM: number): void {
  const { g, palette } = pen;
  g.beginPath();
  g.arc(pen.x(goal.x), pen.y(goal.y), Math.max(leastPx, radiusM * pen.s), 0, 2 * Math.PI);
  g.fillStyle = withAlpha(palette.rgb.accent, 0.12);
  g.fill();
  pen.stroke(palette.css.accent, 1.5, [4, 3]);
  pen.dot(goal.x, goal.y, 3, palette.css.accent);
}

const aheadS = 3;
const stepS = 0.05;

/** Where the robot is within 3 s if nothing changes, its end a dot; a bar where it would stand if stopped now. */
export function drawMotion(pen: Pen, pose: RobotPose, v: number, w: number, decelerationMS2: number): void {
  const { g, palette } = pen;
  const stopM = (v * v) / (2 * decelerationMS2);
  let { x, y, yaw } = pose;
  let gone = 0;
  let bar: RobotPose | null = null;
  g.beginPath();
  pen.move(x, y);
  for (let t = 0; t < aheadS; t += stepS) {
    x += v * stepS * Math.cos(yaw);
    y += v * stepS * Math.sin(yaw);
    yaw += w * stepS;
    gone += Math.abs(v) * stepS;
    if (!bar && gone >= stopM) bar = { x, y, yaw };
    pen.line(x, y);
  }
  g.lineCap = 'round';
  pen.stroke(palette.css.accent, 3);
  g.lineCap = 'butt';
  pen.dot(x, y, 4, palette.css.accent);
  if (!bar || Math.abs(v) < 0.01) return;
  const across = 9 / pen.s;
  g.beginPath();
  pen.move(bar.x - across * Math.sin(bar.yaw), bar.y + across * Math.cos(bar.yaw));
  pen.line(bar.x + across * Math.sin(bar.yaw), bar.y - across * Math.cos(bar.yaw));
  pen.stroke(palette.css.accent, 3);
}
