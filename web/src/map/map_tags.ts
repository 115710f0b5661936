// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

import { runningOf } from '../model/instances.ts';
import type { Model } from '../model/model.ts';
import type { Camera } from '../model/model.ts';
import { type Area, pixelOf } from './camera.ts';
import { arcOfRecord, placeAt } from './echo_arc.ts';
import { robotRadius, type OverlayState, shownPings } from './overlay.ts';
import { stepArc, stepPose } from './step_layer.ts';
import type { Tag } from './tags.ts';

const rejectedFromScale = 34;
const rejectedForS = 2.5;

const capital = (text: string): string => text.charAt(0).toUpperCase() + text.slice(1).replaceAll('_', ' ');
const metres = (m: number): string => `${m.toFixed(2)} m`;
const thousands = (n: number): string => n.toLocaleString('en-US');

/** Labels on the map: the explained point, the stepped sensor, or what was rejected last. */
export function mapTags(model: Model, state: OverlayState, camera: Camera, area: Area): Tag[] {
  const at = (x: number, y: number): { px: number; py: number } => pixelOf(camera, area, x, y);
  if (state.step) return stepTags(model, state, at);
  if (state.explanation) return explainTags(model, state, at);
  if (model.view.name === 'compare' || camera.s < rejectedFromScale) return [];
  const shown = shownPings(model);
  const newest = shown.at(-1);
  const rejected = shown.findLast((p) => p.outcome === 'rejected' && (newest?.t ?? 0) - p.t < rejectedForS);
  if (!rejected || !(rejected.rangeM > 0)) return [];
  const reason = model.welcome?.rejections[rejected.reason]?.name ?? 'unknown reason';
  const place = at(...placeAt(arcOfRecord(rejected, rejected.rangeM, 0), 0));
  return [{ ...place, text: `Rejected: ${reason.replaceAll('_', ' ')}`, kind: 'rejected' }];
}

type At = (x: number, y: number) => { px: number; py: number };

function explainTags(model: Model, { explanation: e, hoveredPing }: OverlayState, at: At): Tag[] {
  if (!e) return [];
  const tags: Tag[] = [];
  const short = runningOf(model.methods, e.method)?.label ?? e.method;
  if (e.kind === 'point') tags.push({ ...at(e.x, e.y), text: e.bound_m === null ? short : `${short} ±${(100 * e.bound_m).toFixed(1)} cm`, kind: '' });
  const hovered = e.support.find((s) => s.ping.ping === hoveredPing)?.ping;
  if (hovered) tags.push({ ...at(hovered.T_world_tx[0], hovered.T_world_tx[1]), text: `Ping ${thousands(hovered.ping)}, sensor ${hovered.rx}`, kind: '' });
  return tags;
}

function stepTags(model: Model, { step }: OverlayState, at: At): Tag[] {
  if (!step) return [];
  const { tx, rx, robot } = stepPose(step);
  const { ping, true_pose: truth } = step.stepped;
  const tags: Tag[] = [{ ...at(tx[0], tx[1]), text: `Sensor ${ping.tx}`, kind: '', side: 'right' }];
  if (ping.range_m !== null) {
    const arc = stepArc(step);
    const end = at(...placeAt(arc, -arc.half));
    tags.push({ ...end, text: ping.outcome === 'rejected' ? capital(`rejected: ${ping.reason ?? ''}`) : `r = ${metres(ping.range_m)}`, kind: ping.outcome === 'rejected' ? 'rejected' : '', side: 'right' });
  }
  if (ping.tx !== ping.rx) tags.push({ ...at(rx[0], rx[1]), text: `Sensor ${ping.rx}`, kind: '', side: 'left' });
  if (step.switches.truePose && truth) tags.push({ ...at(robot[0], robot[1] - robotRadius(model)), text: 'what if', kind: '', side: 'below' });
  return tags;
}
