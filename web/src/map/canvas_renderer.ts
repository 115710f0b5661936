// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

import { tileSide } from '../model/map_store.ts';
import type { MethodMap, Tile } from '../model/method_map.ts';
import { blendedColour, onCellsOf } from './blended.ts';
import { crossSegments } from './crosses.ts';
import { ellipticBounds } from './elliptic_bounds.ts';
import { type Palette, withAlpha } from './palette.ts';
import { drawMark, Pen } from './pen.ts';
import { cellColour, type Rgb } from './ramp.ts';
import {
  boundAlpha, boundHalfAngle, boundsFromScale, boundWidth, type GridLayer, type GroundRenderer, markRadius, nearestFromScale, type PaneScene,
  type PointLayer, type Scene,
} from './scene.ts';
import { slotColour } from './slots.ts';

interface Drawn { canvas: HTMLCanvasElement; key: string }

/** Layers 1 to 8 with Canvas 2-D, where there is no WebGL2. */
export class CanvasRenderer implements GroundRenderer {
  readonly accelerated = false;
  private readonly g: CanvasRenderingContext2D;
  private readonly tiles = new WeakMap<Tile, Drawn>();

  constructor(private readonly canvas: HTMLCanvasElement) {
    const g = canvas.getContext('2d', { alpha: false });
    if (!g) throw new Error('This browser draws neither with WebGL2 nor with Canvas 2-D.');
    this.g = g;
  }

  resize(width: number, height: number, ratio: number): void {
    this.canvas.width = Math.max(1, Math.round(width * ratio));
    this.canvas.height = Math.max(1, Math.round(height * ratio));
    this.g.setTransform(ratio, 0, 0, ratio, 0, 0);
  }

  draw(scene: Scene): boolean {
    for (const pane of scene.panes) {
      this.g.save();
      this.g.beginPath();
      this.g.rect(pane.clip.x, pane.clip.y, pane.clip.width, pane.clip.height);
      this.g.clip();
      this.pane(pane, scene);
      this.g.restore();
    }
    return false;
  }

  private pane(pane: PaneScene, scene: Scene): void {
    const { g } = this;
    const { palette } = scene;
    const pen = new Pen(g, scene.camera, pane.area, palette);
    g.fillStyle = palette.css.unk;
    g.fillRect(pane.area.x, pane.area.y, pane.area.width, pane.area.height);
    for (const grid of pane.grids) this.grid(pen, grid);
    if (pane.crosses) segments(pen, crossSegments(scene.camera, pane.area), () => pen.stroke(palette.css.cross, 1));
    if (pane.truth) segments(pen, scene.walls, () => pen.stroke(withAlpha(palette.rgb.ink3, 0.7), 1, [1, 2.5]));
    if (pane.laser) for (let i = 0; i + 1 < scene.laser.length; i += 2) pen.dot(scene.laser[i] ?? 0, scene.laser[i + 1] ?? 0, 0.6, palette.css.ink3);
    if (pane.path && scene.pathLength >= 4) {
      g.beginPath();
      for (let i = 0; i + 1 < scene.pathLength; i += 2) pen.line(scene.path[i] ?? 0, scene.path[i + 1] ?? 0);
      pen.stroke(withAlpha(palette.rgb.accent, 0.55), 1.5);
    }
    for (const layer of pane.points) if (layer.bounds && pen.s >= boundsFromScale) bounds(pen, layer, scene.arcOf);
    for (const layer of [...pane.points].reverse()) marks(pen, layer, scene.centerlineLabel);
  }

  private grid(pen: Pen, { map, tone, alpha, against }: GridLayer): void {
    if (!map.grid) return;
    const { g } = this;
    g.imageSmoothingEnabled = pen.s < nearestFromScale;
    g.globalAlpha = alpha;
    const side = map.grid.cellM * tileSide;
    const other = against && onCellsOf(against.map, map);
    const keys = other ? new Set([...map.tiles.keys(), ...other.tiles.keys()]) : map.tiles.keys();
    for (const key of keys) {
      const own = map.tiles.get(key);
      const second = other?.tiles.get(key);
      const tile = own ?? second;
      if (!tile) continue;
      const left = pen.x(map.grid.x + tile.column * side);
      const top = pen.y(map.grid.y + (tile.row + 1) * side);
      const size = side * pen.s;
      if (left > pen.area.x + pen.area.width || top > pen.area.y + pen.area.height || left + size < pen.area.x || top + size < pen.area.y) continue;
      const image = against ? this.blended(tile, own, second, against.blend, pen.palette) : this.image(tile, tone, pen.palette);
      g.drawImage(image, left, top, size, size);
    }
    g.globalAlpha = 1;
  }

  private image(tile: Tile, tone: number, palette: Palette): HTMLCanvasElement {
    return this.drawn(tile, `${tile.version} ${tone} ${palette.css.free}`, (k) => cellColour(tile.bytes[k] ?? 0, tone, palette.rgb.unk, palette.rgb.free, palette.rgb.occ));
  }

  private blended(key: Tile, own: Tile | undefined, second: Tile | undefined, blend: number, palette: Palette): HTMLCanvasElement {
    return this.drawn(key, `${own?.version} ${second?.version} blend ${blend} ${palette.css.free}`, (k) => blendedColour(own?.bytes[k] ?? 0, second?.bytes[k] ?? 0, blend, palette));
  }

  private drawn(tile: Tile, key: string, colourOf: (k: number) => Rgb): HTMLCanvasElement {
    const known = this.tiles.get(tile);
    if (known?.key === key) return known.canvas;
    const canvas = known?.canvas ?? document.createElement('canvas');
    canvas.width = canvas.height = tileSide;
    canvas.getContext('2d')?.putImageData(tileImage(colourOf), 0, 0);
    this.tiles.set(tile, { canvas, key });
    return canvas;
  }

  destroy(): void { this.canvas.width = this.canvas.height = 1; }
}

function tileImage(colourOf: (k: number) => Rgb): ImageData {
  const image = new ImageData(tileSide, tileSide);
  for (let j = 0; j < tileSide; j++) {
    for (let i = 0; i < tileSide; i++) {
      const colour = colourOf(j * tileSide + i);
      const at = 4 * ((tileSide - 1 - j) * tileSide + i);
      image.data[at] = 255 * colour[0];
      image.data[at + 1] = 255 * colour[1];
      image.data[at + 2] = 255 * colour[2];
      image.data[at + 3] = 255;
    }
  }
  return image;
}

function segments(pen: Pen, xy: Float32Array, stroke: () => void): void {
  pen.g.beginPath();
  for (let i = 0; i + 3 < xy.length; i += 4) {
    pen.move(xy[i] ?? 0, xy[i + 1] ?? 0);
    pen.line(xy[i + 2] ?? 0, xy[i + 3] ?? 0);
  }
  stroke();
}

/** Calls for every point that lives and is seen. */
function eachSeen(pen: Pen, map: MethodMap, everyNth: number, call: (slot: number, px: number, py: number) => void): void {
  const { area } = pen;
  for (let i = 0; i < map.slots; i += everyNth) {
    if (!map.alive[i]) continue;
    const px = pen.x(map.x[i] ?? 0);
    const py = pen.y(map.y[i] ?? 0);
    if (px > area.x - 8 && py > area.y - 8 && px < area.x + area.width + 8 && py < area.y + area.height + 8) call(i, px, py);
  }
}

function bounds(pen: Pen, { map, slot, everyNth, alpha }: PointLayer, arcOf: Scene['arcOf']): void {
  const { g, palette } = pen;
  const style = withAlpha(palette.rgb[slotColour[slot]], boundAlpha(palette.dark) * alpha);
  segments(pen, ellipticBounds(map, everyNth, arcOf), () => pen.stroke(style, boundWidth(pen.s)));
  g.beginPath();
  eachSeen(pen, map, everyNth, (i) => {
    const [x, y] = [map.arcX[i] ?? Number.NaN, map.arcY[i] ?? Number.NaN];
    const r = Math.hypot((map.x[i] ?? 0) - x, (map.y[i] ?? 0) - y);
    const half = boundHalfAngle(map.boundM[i] ?? Number.NaN, r);
    if (!(half > 0)) return;
    const t = Math.atan2((map.y[i] ?? 0) - y, (map.x[i] ?? 0) - x);
    pen.move(x + r * Math.cos(t + half), y + r * Math.sin(t + half));
    pen.arc(x, y, r, t - half, t + half);
  });
  pen.stroke(style, boundWidth(pen.s));
}

function marks(pen: Pen, { map, slot, everyNth, alpha }: PointLayer, openLabel: number): void {
  const radius = markRadius(pen.s);
  const colour = withAlpha(pen.palette.rgb[slotColour[slot]], alpha);
  eachSeen(pen, map, everyNth, (i, px, py) => drawMark(pen.g, slot, px, py, radius, colour, map.label[i] === openLabel && map.name !== 'centerline'));
}
