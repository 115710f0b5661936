// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

import type { Camera, Model } from '../model/model.ts';
import { type Area, type Box, clampScale, fitted, Flight, followed, panned, zoomedAt } from './camera.ts';
import { contentBox } from './scene_builder.ts';

const fitMarginPx = 40;
const emptyBox: Box = { x0: -4, y0: -3, x1: 4, y1: 3 };
/** Fitting goes on as the map grows, in steps: a camera that creeps makes reading hard. */
const fitSlack = 0.92;

/** Where the camera is: fitting, flying, following, or where the person put it. The view in the model is its memory. */
export class CameraControl {
  private flight: Flight | null = null;
  private fit: { camera: Camera; area: Area } | null = null;
  private readonly calm = matchMedia('(prefers-reduced-motion: reduce)');
  /** So much of the map at its right is under a sheet: what is to be seen goes beside it. */
  coveredPx = 0;
  current: Camera = { x: 0, y: 0, s: 40 };

  constructor(private readonly model: Model, private readonly area: () => Area, private readonly robot: () => { x: number; y: number } | null) {}

  get isCalm(): boolean { return this.calm.matches; }

  /** Camera of this frame; `moving` when the next frame must come without being asked for. */
  update(nowMs: number): { moving: boolean } {
    const { view } = this.model;
    if (this.flight) {
      const { camera, done } = this.flight.at(nowMs);
      this.current = camera;
      if (done) this.flight = null;
      return { moving: !done };
    }
    this.current = view.camera ?? this.fitting();
    const robot = view.follow ? this.robot() : null;
    if (robot) {
      const camera = followed(this.current, this.area(), robot.x, robot.y);
      if (camera.x !== this.current.x || camera.y !== this.current.y) {
        this.current = camera;
        view.camera = camera; // no news for the panels: the camera follows without anyone's doing
      }
    }
    return { moving: false };
  }

  pan(dxPx: number, dyPx: number): void { this.put(panned(this.current, dxPx, dyPx), false); }

  zoom(factor: number, area: Area, px: number, py: number, fly: boolean): void {
    const camera = zoomedAt(this.current, area, factor, px, py);
    if (fly) this.fly(camera, this.model.view.follow);
    else this.put(camera, this.model.view.follow);
  }

  fitAll(): void {
    this.fit = null;
    const from = this.current;
    this.model.show({ camera: null, follow: false });
    this.start(from, this.fitting());
  }

  flyTo(box: Box, maxScale: number): void { this.fly(this.beside(box, 1.6 * fitMarginPx, maxScale), false); }

  resized(): void { this.fit = null; }

  cover(px: number): void {
    this.coveredPx = px;
    this.fit = null;
  }

  private fly(to: Camera, follow: boolean): void {
    const from = this.current;
    const camera = { ...to, s: clampScale(to.s) };
    this.model.show({ camera, follow });
    this.start(from, camera);
  }

  private start(from: Camera, to: Camera): void {
    this.flight = this.calm.matches ? null : new Flight(from, to, performance.now());
    if (!this.flight) this.current = to;
  }

  private put(camera: Camera, follow: boolean): void {
    this.flight = null;
    this.current = camera;
    this.model.show({ camera, follow });
  }

  private beside(box: Box, marginPx: number, maxScale?: number): Camera {
    const area = this.area();
    const covered = this.model.view.name === 'compare' ? 0 : this.coveredPx;
    const camera = fitted(box, { ...area, width: area.width - covered }, marginPx, maxScale);
    return { ...camera, x: camera.x + covered / 2 / camera.s };
  }

  private fitting(): Camera {
    const area = this.area();
    const wanted = this.beside(contentBox(this.model) ?? emptyBox, fitMarginPx);
    const kept = this.fit;
    if (kept && kept.area.width === area.width && kept.area.height === area.height && kept.camera.s <= wanted.s / fitSlack && kept.camera.s >= wanted.s * fitSlack) {
      const offPx = Math.max(Math.abs(kept.camera.x - wanted.x), Math.abs(kept.camera.y - wanted.y)) * wanted.s;
      if (offPx < fitMarginPx / 2) return kept.camera;
    }
    this.fit = { camera: wanted, area };
    return wanted;
  }
}
