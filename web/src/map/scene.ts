// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** What is to be drawn in a pane beneath the robot, for either renderer. */
import type { Camera } from '../model/model.ts';
import type { MethodMap } from '../model/method_map.ts';
import type { Area } from './camera.ts';
import type { EchoArc } from './echo_arc.ts';
import type { Palette } from './palette.ts';
import type { MarkSlot } from './slots.ts';

export interface GridLayer {
  map: MethodMap;
  /** share of `occ` that an occupied cell gets */
  tone: number;
  alpha: number;
  /** A second grid that this one is compared with: 0 this one alone, 0.5 where they agree and where not, 1 the second alone. */
  against?: { map: MethodMap; blend: number };
}

export interface PointLayer { map: MethodMap; slot: MarkSlot; alpha: number; bounds: boolean; everyNth: number }

export interface PaneScene {
  area: Area;
  /** Part of the area that is drawn: Swipe shows one method left and the other right of the divider. */
  clip: Area;
  methods: string[];
  grids: GridLayer[];
  points: PointLayer[];
  crosses: boolean;
  truth: boolean;
  laser: boolean;
  path: boolean;
}

/** Something of a map is seen, not the empty ground alone. */
export const holdsMap = ({ grids, points }: PaneScene): boolean => grids.some((g) => g.map.tiles.size > 0) || points.some((p) => p.map.points > 0);

export interface Scene {
  camera: Camera;
  palette: Palette;
  panes: PaneScene[];
  /** True walls as segments x0, y0, x1, y1; grows with its version. */
  walls: Float32Array;
  wallsVersion: number;
  laser: Float32Array;
  path: Float32Array;
  pathLength: number;
  /** Arc of a ping that is still remembered. */
  arcOf: (ping: number) => EchoArc | null;
  /** Index of the label 'centerline': such points have open marks in the maps of other methods. */
  centerlineLabel: number;
}

export interface GroundRenderer {
  readonly accelerated: boolean;
  /** In CSS pixels and pixels per CSS pixel. */
  resize(width: number, height: number, ratio: number): void;
  /** True when tiles are left to upload in further frames. */
  draw(scene: Scene): boolean;
  destroy(): void;
}

export const markRadius = (s: number): number => Math.max(1.3, Math.min(4.5, 0.034 * s));
export const boundWidth = (s: number): number => Math.max(1, Math.min(3, 0.022 * s));
export const boundAlpha = (dark: boolean): number => (dark ? 0.3 : 0.26);
export const boundsFromScale = 24;
export const nearestFromScale = 40;

/** Half of the angle over which a point may lie on its arc. */
export function boundHalfAngle(boundM: number, radiusM: number): number {
  return 2 * Math.asin(Math.min(0.5, boundM / (2 * radiusM)));
}
