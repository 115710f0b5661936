// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** What the rest of the page may ask of the map, and what the map tells it. All pixels are CSS pixels of the map's host. */
import type { Camera } from '../model/model.ts';
import type { PingRecord } from '../model/ping_store.ts';
import type { Explanation, Stepped } from '../protocol/messages.ts';

/** What lies at a place: the nearest point within 8 px, else the newest arc within 6 px, else, from 90 px/m on, a cell. */
export type Pick =
  | { kind: 'point'; method: string; slot: number; x: number; y: number; ping: number; boundM: number }
  | { kind: 'arc'; ping: PingRecord; x: number; y: number }
  | { kind: 'cell'; method: string; i: number; j: number; x: number; y: number; /** NaN: unknown */ probability: number };

export interface MapPlace {
  /** World metres. */
  x: number;
  y: number;
  px: number;
  py: number;
  /** Pane of Compare, 0 elsewhere; its method, or '' on the map. */
  pane: number;
  method: string;
  pick: Pick | null;
  touch: boolean;
}

export interface ScaleBar { lengthM: number; lengthPx: number; label: string }

/** Area of a pane, and the methods that are drawn in it. */
export interface PaneArea { x: number; y: number; width: number; height: number; methods: string[] }

export interface Measure { lengthM: number; angleRad: number }

export interface StepSwitches {
  /** Draw the ping as a ray on its axis, not as a cone. */
  ray: boolean;
  /** What if the robot had been where it truly was. */
  truePose: boolean;
}

/** `auto`: WebGL2 on a graphics card, else Canvas 2-D; the others are for tests. */
export type RendererChoice = 'auto' | 'webgl2' | 'canvas2d';

export interface MapView {
  /** As it is drawn now, also while it flies or follows; `model.view.camera` is null while it fits. */
  readonly camera: Camera;
  readonly scaleBar: ScaleBar;
  readonly panes: readonly PaneArea[];
  /** 1 in n points is drawn where there are more than can be told apart; 1: all. */
  readonly everyNth: number;
  /** Graphics acceleration: false where Canvas 2-D does all. */
  readonly accelerated: boolean;

  fit(): void;
  /** Flies so that the box is seen, at most `maxScale` px/m. */
  flyTo(box: { x0: number; y0: number; x1: number; y1: number }, maxScale?: number): void;
  zoom(factor: number, px?: number, py?: number): void;
  /** Moves the view; keys call it with 64 or 256 px. */
  pan(dxPx: number, dyPx: number): void;
  toWorld(px: number, py: number): { x: number; y: number };
  toPixels(x: number, y: number): { px: number; py: number };

  pick(px: number, py: number): Pick | null;
  /** The point after (1) or before (-1) the one it gave last, walking outwards from the centre of the view. */
  stepPoint(direction: 1 | -1): Extract<Pick, { kind: 'point' }> | null;

  setExplanation(explanation: Explanation | null, hoveredPing: number | null): void;
  setStep(stepped: Stepped | null, part: number, selectedCell: { i: number; j: number } | null, switches: StepSwitches): void;
  /** Ghost robot and planned line of click-to-go; null: none. */
  setGoal(goal: { x: number; y: number } | null): void;
  /** Blinks the cone of a sensor while its tile is hovered. */
  setSensor(sensor: number | null): void;
  /** Motion curve of who drives here: what was commanded; null: none. */
  setMotion(motion: { v: number; w: number } | null): void;
  /** Areas that tags keep clear of: Stop. */
  setKeepClear(elements: readonly HTMLElement[]): void;
  /** A sheet lies over so many pixels at the right: fitting and flights go beside it. */
  setCovered(rightPx: number): void;

  /** The map as it is seen, as PNG. */
  picture(): Promise<Blob>;

  onClick: ((place: MapPlace) => void) | null;
  /** After 120 ms of rest; null when the pointer left. */
  onHover: ((place: MapPlace | null) => void) | null;
  /** Position under the pointer, at every move. */
  onMove: ((x: number, y: number) => void) | null;
  onLongPress: ((place: MapPlace) => void) | null;
  onMeasure: ((measure: Measure | null) => void) | null;
  /** Camera, scale bar, panes or everyNth changed. */
  onCamera: (() => void) | null;
  /** A click in step mode that hit a changed cell. */
  onStepCell: ((cell: { i: number; j: number }) => void) | null;

  /** Reads the colours again; after the theme changed. */
  retheme(): void;
  destroy(): void;
}

export { createMapView } from './create_map_view.ts';
