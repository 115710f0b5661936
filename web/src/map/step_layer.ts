// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Layer 13 in step mode: one ping over the map before it, part by part. */
import type { Stepped } from '../protocol/messages.ts';
import { gain } from '../step/cells.ts';
import type { Box } from './camera.ts';
import { arcOfDetail, echoArc, type EchoArc, placeAt } from './echo_arc.ts';
import { outlineCell } from './explain_layer.ts';
import type { StepSwitches } from './map_view.ts';
import { withAlpha } from './palette.ts';
import { drawMark, type Pen } from './pen.ts';
import { drawGhost } from './robot.ts';
import { type MarkSlot, slotColour } from './slots.ts';

export interface StepView { stepped: Stepped; part: number; cell: { i: number; j: number } | null; switches: StepSwitches }

/** The last part shows the map after the ping; those before it the map before it. */
export const afterPart = 5;
const numbersFromPx = 30;
const outlinesFromPx = 24;
/** Change that is drawn at full strength, by unit; of others the largest of the ping is. */
const fullChanges: Readonly<Record<string, number>> = { 'log-odds': 2, p: 0.5 };

type Pose = readonly [number, number, number];
export interface SteppedPose { tx: Pose; rx: Pose; robot: Pose }

/** The ping as odometry had it, or moved to where the robot truly was. */
export function stepPose({ stepped, switches }: StepView): SteppedPose {
  const { T_world_tx: tx, T_world_rx: rx, T_world_robot: robot } = stepped.ping;
  const truth = stepped.true_pose;
  if (!switches.truePose || !truth) return { tx, rx, robot };
  const turn = truth[2] - robot[2];
  const [c, s] = [Math.cos(turn), Math.sin(turn)];
  const moved = ([x, y, yaw]: Pose): Pose => {
    const [dx, dy] = [x - robot[0], y - robot[1]];
    return [truth[0] + c * dx - s * dy, truth[1] + s * dx + c * dy, yaw + turn];
  };
  return { tx: moved(tx), rx: moved(rx), robot: truth };
}

/** The arc that is drawn: a ray has no width. */
export function stepArc(view: StepView): EchoArc {
  const { ping } = view.stepped;
  const { tx, rx } = stepPose(view);
  return echoArc(tx, rx, ping.range_m ?? ping.trusted_range_m, view.switches.ray ? 0 : ping.beam_width / 2);
}

function drawCells(pen: Pen, { stepped, cell }: StepView): void {
  const size = stepped.cell_m ?? 0;
  const fullChange = fullChanges[stepped.unit] ?? Math.max(1e-9, ...stepped.cells.map((c) => Math.abs(c.after - c.before)));
  const px = size * pen.s;
  const { g, palette: { rgb, css, dark, font } } = pen;
  if (px <= 0) return;
  g.textAlign = 'center';
  g.textBaseline = 'middle';
  g.font = `500 ${Math.min(13, 0.3 * px)}px ${font}`;
  for (const c of stepped.cells) {
    const change = c.after - c.before;
    if (change === 0) continue;
    const strength = Math.max(0.1, Math.min(0.85, 0.1 + (0.75 * Math.abs(change)) / fullChange));
    const left = pen.x(c.x - size / 2);
    const top = pen.y(c.y + size / 2);
    g.fillStyle = withAlpha(gain(c, stepped.unit) > 0 ? rgb.fuller : rgb.emptier, strength);
    g.fillRect(left + 0.5, top + 0.5, px - 1, px - 1);
    if (px < numbersFromPx) continue;
    g.fillStyle = strength > 0.62 && !dark ? css.surface : css.ink;
    g.fillText(`${change > 0 ? '+' : '−'}${Math.abs(change).toFixed(1)}`, left + px / 2, top + px / 2 + 1);
  }
  const chosen = cell && stepped.cells.find((c) => c.i === cell.i && c.j === cell.j);
  if (chosen) outlineCell(pen, chosen.x, chosen.y, size);
}

/** Hairlines between the method's cells, once these are large enough. */
export function drawCellLines(pen: Pen, cellM: number, originX: number, originY: number): void {
  const px = cellM * pen.s;
  if (px < outlinesFromPx) return;
  const { g, area, camera } = pen;
  const left = camera.x - area.width / 2 / pen.s;
  const bottom = camera.y - area.height / 2 / pen.s;
  g.beginPath();
  for (let x = originX + Math.ceil((left - originX) / cellM) * cellM; pen.x(x) < area.x + area.width; x += cellM) {
    const at = Math.round(pen.x(x)) + 0.5;
    g.moveTo(at, area.y);
    g.lineTo(at, area.y + area.height);
  }
  for (let y = originY + Math.ceil((bottom - originY) / cellM) * cellM; pen.y(y) > area.y; y += cellM) {
    const at = Math.round(pen.y(y)) + 0.5;
    g.moveTo(area.x, at);
    g.lineTo(area.x + area.width, at);
  }
  pen.stroke(withAlpha(pen.palette.rgb.cross, 0.75), 1);
}

function drawArcs(pen: Pen, { stepped }: StepView): void {
  const { rgb, css } = pen.palette;
  for (const arc of stepped.arcs) {
    const whole = arcOfDetail(arc.ping);
    pen.g.beginPath();
    pen.echo(whole);
    pen.stroke(withAlpha(rgb.hit, arc.what === 'crossed' ? 0.62 : 0.3), 1.75);
    if (arc.t_begin !== null && arc.t_end !== null) {
      pen.g.beginPath();
      pen.echo(whole, arc.t_begin, arc.t_end);
      pen.stroke(arc.what === 'crossed' ? css.hit : css.rej, 3, arc.what === 'removed' ? [4, 3] : []);
    }
    if (arc.x === null || arc.y === null) continue;
    pen.dot(arc.x, arc.y, 4, css.surface);
    pen.stroke(css.hit, 1.75);
  }
}

/** The points that the ping brought, larger than those that were there. */
function drawNewPoints(pen: Pen, points: Stepped['points'], slot: MarkSlot): void {
  const { css } = pen.palette;
  for (const [x, y] of points) {
    drawMark(pen.g, slot, pen.x(x), pen.y(y), 8, css.surface);
    drawMark(pen.g, slot, pen.x(x), pen.y(y), 6, css[slotColour[slot]]);
  }
}

export function drawStep(pen: Pen, view: StepView, slot: MarkSlot, robotRadiusM: number): void {
  const { stepped, part, switches } = view;
  const { g, palette: { css, rgb } } = pen;
  const { tx, rx } = stepPose(view);
  const arc = stepArc(view);
  const middle = placeAt(arc, 0);
  if (part === 4 && stepped.used) {
    drawCells(pen, view);
    drawArcs(pen, view);
  }
  if (switches.truePose && stepped.true_pose) drawGhost(pen, stepped.ping.T_world_robot[0], stepped.ping.T_world_robot[1], robotRadiusM);
  const colour = stepped.ping.outcome === 'rejected' ? 'rej' : stepped.ping.outcome === 'echo' ? 'hit' : 'none';
  if (part >= 3 || part === 1) {
    pen.sector(arc);
    pen.stroke(css[colour], 1.5, colour === 'rej' ? [5, 4] : []);
    if (part === 3 && !switches.ray) {
      g.fillStyle = withAlpha(rgb[colour], 0.1);
      g.fill();
    }
  }
  g.beginPath();
  for (const [x, y] of [tx, rx]) {
    pen.move(x, y);
    pen.line(...middle);
  }
  pen.stroke(css[colour], 1, [3, 3]);
  if (part >= 3 && stepped.ping.outcome === 'echo') {
    g.lineCap = 'round';
    g.beginPath();
    pen.echo(arc);
    pen.stroke(css.hit, 4);
    g.lineCap = 'butt';
    if (switches.ray) pen.dot(...middle, 5, css.hit);
  }
  for (const [x, y] of [tx, rx]) pen.dot(x, y, 5, css[colour]);
  const tellsOfPoints = part === afterPart || (part === 4 && stepped.cells.length === 0);
  if (tellsOfPoints && stepped.used) drawNewPoints(pen, stepped.points, slot);
}

export function stepBox(view: StepView, robotRadiusM: number): Box {
  const { tx, rx } = stepPose(view);
  const { ping } = view.stepped;
  const arc = stepArc({ ...view, switches: { ...view.switches, ray: false } });
  const [robotX, robotY] = ping.T_world_robot;
  const ends = [-arc.half, 0, arc.half].map((t) => placeAt(arc, t));
  const xs = [tx[0], rx[0], robotX - robotRadiusM, robotX + robotRadiusM, ...ends.map(([x]) => x)];
  const ys = [tx[1], rx[1], robotY - robotRadiusM, robotY + robotRadiusM, ...ends.map(([, y]) => y)];
  return { x0: Math.min(...xs), y0: Math.min(...ys), x1: Math.max(...xs), y1: Math.max(...ys) };
}
