// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Layers 9 to 13: what lies over the ground, on the 2-D canvas. */
import type { Model } from '../model/model.ts';
import type { PingRecord } from '../model/ping_store.ts';
import type { Explanation, Plan } from '../protocol/messages.ts';
import { drawArcs, drawCones } from './cones.ts';
import { arcOfRecord, type EchoArc } from './echo_arc.ts';
import { dimAlpha, drawExplanation, outlineCell } from './explain_layer.ts';
import { withAlpha } from './palette.ts';
import type { Pen } from './pen.ts';
import { drawPlan } from './plan_layer.ts';
import { drawGoal, drawMotion, drawRobot, type RobotPose } from './robot.ts';
import { markSlots, type MarkSlot } from './slots.ts';
import { drawCellLines, drawStep, stepPose, type StepView } from './step_layer.ts';

const fadeS = 0.9;
const rejectedShown = 100;
const leastAlpha = 0.28;
const defaultRadiusM = 0.2;
const defaultHalfAngle = 0.22;

export interface OverlayState {
  explanation: Explanation | null;
  hoveredPing: number | null;
  step: StepView | null;
  goal: { x: number; y: number } | null;
  motion: { v: number; w: number } | null;
  sensor: number | null;
  blinkOn: boolean;
  measure: { x0: number; y0: number; x1: number; y1: number } | null;
  cursor: { x: number; y: number } | null;
  calm: boolean;
}

export function robotRadius(model: Model): number { return model.welcome?.robot.radius_m ?? defaultRadiusM; }

export function halfAngles(model: Model): (ping: PingRecord) => number {
  const widths = new Map(model.welcome?.robot.sensors.map((s) => [s.id, s.beam_width / 2]));
  return (ping) => widths.get(ping.rx) ?? defaultHalfAngle;
}

/** The arc of an echo among the pings that the page remembers. */
export function arcsOf(model: Model): (ping: number) => EchoArc | null {
  const halfAngleOf = halfAngles(model);
  return (id) => {
    const ping = model.pings.byId(id);
    return ping?.outcome === 'echo' ? arcOfRecord(ping, ping.rangeM, halfAngleOf(ping)) : null;
  };
}

/** Pings whose arcs are on the map, oldest first: those of the last scan, the last 250, of one sensor, or rejected for one reason. */
export function shownPings(model: Model): readonly PingRecord[] {
  const { view } = model;
  if (!view.layers.has('arcs') || view.name === 'explain' || view.name === 'step') return [];
  const recent = model.held?.recent ?? model.pings.recent;
  if (view.arcs === '250') return recent.slice(-250);
  const reason = /^r(\d+)$/.exec(view.arcs)?.[1];
  if (reason !== undefined) return recent.filter((p) => p.outcome === 'rejected' && p.reason === Number(reason)).slice(-rejectedShown);
  const sensor = /^s(\d+)$/.exec(view.arcs)?.[1];
  const some = sensor === undefined ? recent.slice(-256) : recent.filter((p) => p.rx === Number(sensor)).slice(-16);
  if (sensor !== undefined) return some;
  // The newest of each pair of sensors: a whole scan, whatever the order they fire in.
  const newest = new Map<string, PingRecord>();
  for (const ping of some) newest.set(`${ping.tx} ${ping.rx}`, ping);
  const now = recent.at(-1)?.t ?? 0;
  return [...newest.values()].filter((p) => now - p.t < 2).sort((a, b) => a.id - b.id);
}

export function robotPose(model: Model, state: OverlayState): RobotPose | null {
  if (state.step) {
    const { robot } = stepPose(state.step);
    return { x: robot[0], y: robot[1], yaw: robot[2] };
  }
  const pose = model.held ? model.held.pose : model.state?.pose;
  return pose ? { x: pose[0], y: pose[1], yaw: pose[2] } : null;
}

export function drawOverlay(pen: Pen, model: Model, state: OverlayState): void {
  const { g, area, palette } = pen;
  const explaining = state.explanation;
  if (explaining) {
    g.fillStyle = withAlpha(palette.rgb.free, dimAlpha);
    g.fillRect(area.x, area.y, area.width, area.height);
  }
  if (model.view.name !== 'compare') cones(pen, model, state);
  if (state.step) cellLines(pen, model, state.step);
  const pose = robotPose(model, state);
  if (pose && !explaining) robot(pen, model, state, pose);
  if (explaining) explanation(pen, model, explaining, state.hoveredPing);
  if (state.step) drawStep(pen, state.step, slotOf(model, state.step.stepped.method), robotRadius(model));
  if (state.measure) measure(pen, state.measure);
  if (state.cursor && model.view.name === 'compare' && model.view.compare.mode === 'side') cross(pen, state.cursor);
}

function slotOf(model: Model, method: string): MarkSlot { return markSlots(model.methods, model.view.shown).get(method) ?? 1; }

function cones(pen: Pen, model: Model, state: OverlayState): void {
  const pings = shownPings(model);
  const halfAngleOf = halfAngles(model);
  if (model.view.arcs === '250') {
    drawArcs(pen, pings, halfAngleOf);
    return;
  }
  const now = pings.at(-1)?.t ?? 0;
  const alphaOf = (p: PingRecord): number => {
    if (state.sensor === p.rx) return state.blinkOn ? 1 : leastAlpha;
    return state.calm || model.view.arcs.startsWith('r') ? 1 : Math.max(leastAlpha, 1 - (now - p.t) / fadeS);
  };
  drawCones(pen, pings, { halfAngleOf, alphaOf });
}

function cellLines(pen: Pen, model: Model, { stepped }: StepView): void {
  const grid = model.maps.get(stepped.method)?.grid;
  const cellM = stepped.cell_m ?? grid?.cellM;
  if (cellM) drawCellLines(pen, cellM, grid?.x ?? 0, grid?.y ?? 0);
}

/** What the strategy has in mind now, where the view looks at now. */
function shownPlan(model: Model): Plan | null {
  const { view, plan, held } = model;
  const there = view.layers.has('plan') && view.name !== 'compare' && view.name !== 'step' && !held;
  return there ? plan : null;
}

function robot(pen: Pen, model: Model, state: OverlayState, pose: RobotPose): void {
  const radius = robotRadius(model);
  const plan = shownPlan(model);
  if (plan) drawPlan(pen, plan, pose, radius);
  const goal = state.goal ?? (model.state?.goal && !model.held ? { x: model.state.goal[0], y: model.state.goal[1] } : null);
  if (goal && !state.step && !plan) drawGoal(pen, pose, goal, radius);
  if (state.motion && !model.held) drawMotion(pen, pose, state.motion.v, state.motion.w, model.welcome?.limits.stop_deceleration_m_s2 ?? 1.5);
  drawRobot(pen, pose, radius);
}

function explanation(pen: Pen, model: Model, e: Explanation, hovered: number | null): void {
  drawExplanation(pen, e, hovered, slotOf(model, e.method), robotRadius(model));
  const grid = e.cell ? model.maps.get(e.cell.method)?.grid : null;
  if (e.kind === 'cell' && e.cell && grid) outlineCell(pen, grid.x + (e.cell.i + 0.5) * grid.cellM, grid.y + (e.cell.j + 0.5) * grid.cellM, grid.cellM);
}

function measure(pen: Pen, m: { x0: number; y0: number; x1: number; y1: number }): void {
  pen.g.beginPath();
  pen.move(m.x0, m.y0);
  pen.line(m.x1, m.y1);
  pen.stroke(pen.palette.css.surface, 4);
  pen.stroke(pen.palette.css.ink, 1.5);
  for (const [x, y] of [[m.x0, m.y0], [m.x1, m.y1]] as const) pen.dot(x, y, 3, pen.palette.css.ink);
}

/** The cursor in every pane, so that the same place is found in all. */
function cross(pen: Pen, at: { x: number; y: number }): void {
  const [px, py] = [Math.round(pen.x(at.x)) + 0.5, Math.round(pen.y(at.y)) + 0.5];
  pen.g.beginPath();
  pen.g.moveTo(px - 9, py);
  pen.g.lineTo(px + 9, py);
  pen.g.moveTo(px, py - 9);
  pen.g.lineTo(px, py + 9);
  pen.stroke(pen.palette.css.ink2, 1);
}
