// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

import type { Model } from '../model/model.ts';
import type { Camera } from '../model/model.ts';
import { type Area, pixelOf } from './camera.ts';
import { robotRadius, type OverlayState, shownPings } from './overlay.ts';
import { stepPose } from './step_layer.ts';
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
  const place = at(rejected.txX + rejected.rangeM * Math.cos(rejected.txYaw), rejected.txY + rejected.rangeM * Math.sin(rejected.txYaw));
  return [{ ...place, text: `Rejected: ${reason.replaceAll('_', ' ')}`, kind: 'rejected' }];
}

type At = (x: number, y: number) => { px: number; py: number };

function explainTags(model: Model, { explanation: e, hoveredPing }: OverlayState, at: At): Tag[] {
  if (!e) return [];
  const tags: Tag[] = [];
  const short = model.welcome?.catalogue.find((m) => m.name === e.method)?.short ?? e.method;
  if (e.kind === 'point') tags.push({ ...at(e.x, e.y), text: e.bound_m === null ? short : `${short} ±${(100 * e.bound_m).toFixed(1)} cm`, kind: '' });
  const hovered = e.support.find((s) => s.ping.ping === hoveredPing)?.ping;
  if (hovered) tags.push({ ...at(hovered.T_world_tx[0], hovered.T_world_tx[1]), text: `Ping ${thousands(hovered.ping)}, sensor ${hovered.rx}`, kind: '' });
  return tags;
}

function stepTags(model: Model, { step }: OverlayState, at: At): Tag[] {
  if (!step) return [];
  const { x, y, yaw, robot } = stepPose(step);
  const { ping, true_pose: truth } = step.stepped;
  const tags: Tag[] = [{ ...at(x, y), text: `Sensor ${ping.tx}`, kind: '', beside: true }];
  const half = step.switches.ray ? 0 : ping.beam_width / 2;
  if (ping.range_m !== null) {
    const end = at(x + ping.range_m * Math.cos(yaw - half), y + ping.range_m * Math.sin(yaw - half));
    tags.push({ ...end, text: ping.outcome === 'rejected' ? capital(`rejected: ${ping.reason ?? ''}`) : `r = ${metres(ping.range_m)}`, kind: ping.outcome === 'rejected' ? 'rejected' : '', beside: true });
  }
  if (step.switches.truePose && truth) tags.push({ ...at(robot[0], robot[1] - robotRadius(model)), text: 'what if', kind: '' });
  return tags;
}
