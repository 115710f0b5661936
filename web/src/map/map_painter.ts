// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

import type { Model } from '../model/model.ts';
import type { Explanation, Stepped } from '../protocol/messages.ts';
import { type Area, type Box, pixelOf, worldOf } from './camera.ts';
import { CameraControl } from './camera_control.ts';
import { explanationBox } from './explain_layer.ts';
import { FrameClock } from './frame_clock.ts';
import { Gestures } from './gestures.ts';
import { mapTags } from './map_tags.ts';
import type { MapPlace, MapView, Measure, PaneArea, Pick, RendererChoice, ScaleBar, StepSwitches } from './map_view.ts';
import { arcsOf, drawOverlay, halfAngles, type OverlayState, robotPose, robotRadius, shownPings } from './overlay.ts';
import { type Palette, readPalette } from './palette.ts';
import { Pen } from './pen.ts';
import { makeCanvas, makeGround, pictureOf, wallSegments } from './map_parts.ts';
import { nextPoint, pickAt, type PointPick } from './pick.ts';
import { scaleBar } from './scale_bar.ts';
import { type GroundRenderer, holdsMap, type PaneScene, type Scene } from './scene.ts';
import { buildPanes } from './scene_builder.ts';
import { afterPart, stepBox } from './step_layer.ts';
import { Tags } from './tags.ts';

const [explainScale, stepScale] = [300, 340];
const hoverRestMs = 120;
const blinkMs = 250;
const dataTopics = ['state', 'plan', 'pings', 'map', 'path', 'laser', 'methods', 'welcome', 'view'] as const;

/** The map: keeps the two canvases, asks the parts what to draw, and draws it when something changed. */
export class MapPainter implements MapView {
  onClick: ((place: MapPlace) => void) | null = null;
  onHover: ((place: MapPlace | null) => void) | null = null;
  onMove: ((x: number, y: number) => void) | null = null;
  onLongPress: ((place: MapPlace) => void) | null = null;
  onMeasure: ((measure: Measure | null) => void) | null = null;
  onCamera: (() => void) | null = null;
  onStepCell: ((cell: { i: number; j: number }) => void) | null = null;

  private readonly over: HTMLCanvasElement;
  private readonly g: CanvasRenderingContext2D;
  private readonly ground: GroundRenderer;
  private readonly clock: FrameClock;
  private readonly gestures: Gestures;
  private readonly tags: Tags;
  private readonly control: CameraControl;
  private readonly observer: ResizeObserver;
  private readonly unsubscribe: (() => void)[];
  private palette: Palette;
  private width = 1;
  private height = 1;
  private ratio = 1;
  private scenes: PaneScene[] = [];
  private walls = { of: null as unknown, segments: new Float32Array(0), version: 0 };
  private hoverTimer: ReturnType<typeof setTimeout> | undefined;
  private blinkTimer: ReturnType<typeof setInterval> | undefined;
  private walked: PointPick | null = null;
  private told = '';
  private readonly overlay: OverlayState = {
    explanation: null, hoveredPing: null, step: null, goal: null, motion: null, sensor: null, blinkOn: true, measure: null, cursor: null,
    calm: false,
  };

  constructor(private readonly host: HTMLElement, private readonly model: Model, renderer: RendererChoice) {
    const ground = makeGround(host, renderer, () => this.clock.soon());
    this.ground = ground;
    this.over = makeCanvas(host, 'map-canvas over');
    const g = this.over.getContext('2d');
    if (!g) throw new Error('This browser does not draw.');
    this.g = g;
    this.palette = readPalette(host);
    this.clock = new FrameClock((now) => this.draw(now));
    this.tags = new Tags(host);
    this.control = new CameraControl(model, () => this.firstArea(), () => robotPose(model, this.overlay));
    this.gestures = new Gestures(host, {
      pan: (dx, dy) => this.pan(dx, dy),
      zoom: (factor, px, py) => this.control.zoom(factor, this.paneAt(px, py).area, px, py, false),
      click: (px, py, touch) => this.click(px, py, touch),
      longPress: (px, py, touch) => this.onLongPress?.(this.placeAt(px, py, touch)),
      hover: (px, py) => this.hover(px, py),
      leave: () => this.leave(),
      measure: (from, to) => this.measure(from, to),
    });
    this.unsubscribe = dataTopics.map((topic) => model.on(topic, () => (topic === 'view' ? this.clock.soon() : this.clock.later())));
    this.observer = new ResizeObserver(() => this.resize());
    this.observer.observe(host);
    this.resize();
  }

  get camera() { return this.control.current; }
  get scaleBar(): ScaleBar { return scaleBar(this.camera.s); }
  get accelerated(): boolean { return this.ground.accelerated; }
  get panes(): readonly PaneArea[] { return this.scenes.map(({ area, methods }) => ({ ...area, methods })); }
  get everyNth(): number { return Math.max(1, ...this.scenes.flatMap((pane) => pane.points.map((p) => p.everyNth))); }

  fit(): void { this.control.fitAll(); }
  flyTo(box: Box, maxScale = explainScale): void { this.control.flyTo(box, maxScale); }
  pan(dxPx: number, dyPx: number): void { this.control.pan(dxPx, dyPx); }
  toWorld(px: number, py: number): { x: number; y: number } { return worldOf(this.camera, this.paneAt(px, py).area, px, py); }
  toPixels(x: number, y: number): { px: number; py: number } { return pixelOf(this.camera, this.firstArea(), x, y); }

  zoom(factor: number, px?: number, py?: number): void {
    const area = this.firstArea();
    this.control.zoom(factor, area, px ?? area.x + area.width / 2, py ?? area.y + area.height / 2, true);
  }

  pick(px: number, py: number): Pick | null {
    const pane = this.paneAt(px, py);
    const { x, y } = worldOf(this.camera, pane.area, px, py);
    return pickAt({
      s: this.camera.s, points: pane.points.map((p) => p.map), grids: pane.grids.filter((l) => l.tone > 0).map((l) => l.map),
      arcs: this.model.view.name === 'compare' ? [] : shownPings(this.model), halfAngleOf: halfAngles(this.model),
    }, x, y);
  }

  stepPoint(direction: 1 | -1): PointPick | null {
    this.walked = nextPoint(this.scenes[0]?.points.map((p) => p.map) ?? [], this.camera, this.firstArea(), this.walked, direction);
    return this.walked;
  }

  setExplanation(explanation: Explanation | null, hoveredPing: number | null): void {
    const isNew = explanation !== null && explanation !== this.overlay.explanation;
    this.overlay.explanation = explanation;
    this.overlay.hoveredPing = hoveredPing;
    if (isNew) this.flyTo(explanationBox(explanation), explainScale);
    this.clock.soon();
  }

  setStep(stepped: Stepped | null, part: number, cell: { i: number; j: number } | null, switches: StepSwitches): void {
    const before = this.overlay.step?.stepped;
    this.overlay.step = stepped && { stepped, part, cell, switches };
    if (this.overlay.step && stepped !== before) this.flyTo(stepBox(this.overlay.step, robotRadius(this.model)), stepScale);
    this.clock.soon();
  }

  setGoal(goal: { x: number; y: number } | null): void { this.overlay.goal = goal; this.clock.soon(); }
  setMotion(motion: { v: number; w: number } | null): void { this.overlay.motion = motion; this.clock.soon(); }
  setKeepClear(elements: readonly HTMLElement[]): void { this.tags.setKeepClear(elements); }
  setCovered(px: number): void { this.control.cover(px); this.clock.soon(); }

  setSensor(sensor: number | null): void {
    this.overlay.sensor = sensor;
    this.overlay.blinkOn = true;
    clearInterval(this.blinkTimer);
    if (sensor !== null && !this.control.isCalm) {
      this.blinkTimer = setInterval(() => { this.overlay.blinkOn = !this.overlay.blinkOn; this.clock.later(); }, blinkMs);
    }
    this.clock.soon();
  }

  /** Both canvases drawn anew and read in the same turn: their buffers are gone after it. */
  async picture(): Promise<Blob> {
    this.draw(performance.now());
    return await pictureOf(this.host, this.over.width, this.over.height);
  }

  retheme(): void {
    this.palette = readPalette(this.host);
    this.clock.soon();
  }

  destroy(): void {
    for (const off of this.unsubscribe) off();
    this.observer.disconnect();
    this.clock.stop();
    this.gestures.destroy();
    clearTimeout(this.hoverTimer);
    clearInterval(this.blinkTimer);
    this.ground.destroy();
    this.host.replaceChildren(...[...this.host.children].filter((e) => !e.matches('.map-canvas, .map-tag')));
  }

  private firstArea(): Area { return this.scenes[0]?.area ?? { x: 0, y: 0, width: this.width, height: this.height }; }

  private paneAt(px: number, py: number): PaneScene {
    const inside = ({ clip }: PaneScene): boolean => px >= clip.x && px < clip.x + clip.width && py >= clip.y && py < clip.y + clip.height;
    return this.scenes.find(inside) ?? this.scenes[0] ?? this.makePanes()[0] as PaneScene;
  }

  private placeAt(px: number, py: number, touch: boolean): MapPlace {
    const scene = this.paneAt(px, py);
    const { x, y } = worldOf(this.camera, scene.area, px, py);
    const isCompare = this.model.view.name === 'compare';
    return { x, y, px, py, pane: Math.max(0, this.scenes.indexOf(scene)), method: isCompare ? scene.methods[0] ?? '' : '', pick: this.pick(px, py), touch };
  }

  private click(px: number, py: number, touch: boolean): void {
    const place = this.placeAt(px, py, touch);
    const { step } = this.overlay;
    const half = (step?.stepped.cell_m ?? 0) / 2;
    const cell = step?.stepped.cells.find((c) => Math.abs(c.x - place.x) <= half && Math.abs(c.y - place.y) <= half);
    if (cell) this.onStepCell?.({ i: cell.i, j: cell.j });
    else this.onClick?.(place);
  }

  private hover(px: number, py: number): void {
    const at = this.toWorld(px, py);
    this.onMove?.(at.x, at.y);
    if (this.model.view.name === 'compare') {
      this.overlay.cursor = at;
      this.clock.soon();
    }
    clearTimeout(this.hoverTimer);
    this.hoverTimer = setTimeout(() => this.onHover?.(this.placeAt(px, py, false)), hoverRestMs);
  }

  private leave(): void {
    clearTimeout(this.hoverTimer);
    this.overlay.cursor = null;
    this.onHover?.(null);
    this.clock.soon();
  }

  private measure(from: { px: number; py: number } | null, to: { px: number; py: number } | null): void {
    const a = from && this.toWorld(from.px, from.py);
    const b = to && this.toWorld(to.px, to.py);
    this.overlay.measure = a && b ? { x0: a.x, y0: a.y, x1: b.x, y1: b.y } : null;
    this.onMeasure?.(a && b ? { lengthM: Math.hypot(b.x - a.x, b.y - a.y), angleRad: Math.atan2(b.y - a.y, b.x - a.x) } : null);
    this.clock.soon();
  }

  private resize(): void {
    this.width = Math.max(1, this.host.clientWidth);
    this.height = Math.max(1, this.host.clientHeight);
    this.ratio = this.clock.slow ? 1 : Math.min(2, devicePixelRatio || 1);
    this.ground.resize(this.width, this.height, this.ratio);
    this.over.width = Math.round(this.width * this.ratio);
    this.over.height = Math.round(this.height * this.ratio);
    this.control.resized();
    this.scenes = this.makePanes();
    this.clock.soon();
  }

  private makePanes(): PaneScene[] {
    const { model } = this;
    const { step } = this.overlay;
    // The map before the ping came with the answer; the one after it is that of the moment that is held.
    const before = step && step.part < afterPart ? model.framesOf(step.stepped.id)?.maps : undefined;
    const maps = before && before.size > 0 ? new Map([...model.maps, ...before]) : model.maps;
    return buildPanes({ model, maps, stepped: step?.stepped.method ?? null, width: this.width, height: this.height, s: this.camera.s, slow: this.clock.slow });
  }

  private draw(now: number): void {
    if (document.hidden) return;
    if (this.clock.slow && this.ratio > 1) this.resize();
    this.scenes = this.makePanes();
    const { moving } = this.control.update(now);
    this.overlay.calm = this.control.isCalm;
    const late = this.ground.draw(this.scene());
    // When the map was first there, ms since the page was asked for: for who measures it from outside.
    if (!this.host.dataset['mapMs'] && this.scenes.some(holdsMap)) this.host.dataset['mapMs'] = String(Math.round(performance.now()));
    this.drawOver();
    this.tags.show(mapTags(this.model, this.overlay, this.camera, this.firstArea()), this.width - this.control.coveredPx, this.height);
    this.tell();
    if (moving || late) this.clock.soon();
  }

  private scene(): Scene {
    const { model } = this;
    const source = model.welcome?.source.walls;
    if (source !== this.walls.of) this.walls = { of: source, segments: wallSegments(source ?? []), version: this.walls.version + 1 };
    return {
      camera: this.camera, palette: this.palette, panes: this.scenes, walls: this.walls.segments, wallsVersion: this.walls.version,
      laser: model.laser, path: model.path, pathLength: model.pathLength, arcOf: arcsOf(model), centerlineLabel: model.welcome?.labels.indexOf('centerline') ?? -1,
    };
  }

  private drawOver(): void {
    const { g } = this;
    g.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    g.clearRect(0, 0, this.width, this.height);
    for (const pane of this.scenes) {
      g.save();
      g.beginPath();
      g.rect(pane.clip.x, pane.clip.y, pane.clip.width, pane.clip.height);
      g.clip();
      drawOverlay(new Pen(g, this.camera, pane.area, this.palette), this.model, this.overlay);
      g.restore();
    }
    if (this.model.view.name === 'compare') this.drawGutters();
  }

  private drawGutters(): void {
    const { g } = this;
    const swipe = this.model.view.compare.mode === 'swipe';
    g.fillStyle = swipe ? this.palette.css.ink : this.palette.css.line2;
    for (const { clip } of this.scenes) {
      if (clip.x > 0) g.fillRect(Math.round(clip.x) - (swipe ? 1 : 0), clip.y, swipe ? 2 : 1, clip.height);
      if (clip.y > 0) g.fillRect(clip.x, Math.round(clip.y), clip.width, 1);
    }
  }

  private tell(): void {
    const { x, y, s } = this.camera;
    const key = `${x},${y},${s},${this.everyNth},${this.scenes.map((p) => `${p.area.x},${p.area.y},${p.methods}`)},${this.width},${this.height}`;
    if (key === this.told) return;
    this.told = key;
    this.onCamera?.();
  }
}
