// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

import type { Area } from './camera.ts';
import { crossSegments } from './crosses.ts';
import { ellipticBounds } from './elliptic_bounds.ts';
import { GlGrid } from './gl_grid.ts';
import { GlLines } from './gl_lines.ts';
import { GlPoints } from './gl_points.ts';
import { GlBuffer } from './gl_program.ts';
import { boundAlpha, boundWidth, type GroundRenderer, type PaneScene, type Scene } from './scene.ts';
import { slotColour } from './slots.ts';

interface Parts { grid: GlGrid; points: GlPoints; lines: GlLines; crosses: GlBuffer; walls: GlBuffer; laser: GlBuffer; path: GlBuffer; ellipses: GlBuffer }

/** Layers 1 to 8 of the map with WebGL2. After a lost context all is built anew from the stores. */
export class GlRenderer implements GroundRenderer {
  readonly accelerated = true;
  private parts: Parts | null;
  private ratio = 1;
  private height = 1;
  private wallsVersion = -1;
  private pathWritten = 0;

  private constructor(private readonly canvas: HTMLCanvasElement, private readonly gl: WebGL2RenderingContext, private readonly again: () => void) {
    this.parts = this.build();
    canvas.addEventListener('webglcontextlost', this.lost);
    canvas.addEventListener('webglcontextrestored', this.restored);
  }

  /** Null where there is no WebGL2, or, unless `evenSlow`, where it is computed in software: Canvas 2-D is faster then. */
  static make(canvas: HTMLCanvasElement, evenSlow: boolean, again: () => void): GlRenderer | null {
    const gl = canvas.getContext('webgl2', { antialias: false, depth: false, alpha: false, failIfMajorPerformanceCaveat: !evenSlow });
    if (gl && (evenSlow || !isSoftware(gl))) return new GlRenderer(canvas, gl, again);
    gl?.getExtension('WEBGL_lose_context')?.loseContext();
    return null;
  }

  private readonly lost = (event: Event): void => {
    event.preventDefault();
    this.parts = null;
  };

  private readonly restored = (): void => {
    this.parts = this.build();
    this.again();
  };

  private build(): Parts {
    const { gl } = this;
    this.wallsVersion = -1;
    this.pathWritten = 0;
    const buffer = (): GlBuffer => new GlBuffer(gl);
    return {
      grid: new GlGrid(gl), points: new GlPoints(gl), lines: new GlLines(gl), crosses: buffer(), walls: buffer(), laser: buffer(),
      path: buffer(), ellipses: buffer(),
    };
  }

  resize(width: number, height: number, ratio: number): void {
    this.canvas.width = Math.max(1, Math.round(width * ratio));
    this.canvas.height = Math.max(1, Math.round(height * ratio));
    this.ratio = ratio;
    this.height = height;
  }

  draw(scene: Scene): boolean {
    const { gl, parts } = this;
    if (!parts) return false;
    this.write(scene, parts);
    gl.enable(gl.SCISSOR_TEST);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    parts.grid.begin();
    for (const pane of scene.panes) this.pane(pane, scene, parts);
    return parts.grid.late > 0;
  }

  private write(scene: Scene, parts: Parts): void {
    if (this.wallsVersion !== scene.wallsVersion) {
      parts.walls.write(scene.walls, scene.walls.length);
      this.wallsVersion = scene.wallsVersion;
    }
    if (this.pathWritten !== scene.pathLength) {
      parts.path.write(scene.path, scene.pathLength);
      this.pathWritten = scene.pathLength;
    }
  }

  private box(area: Area): [number, number, number, number] {
    const { ratio } = this;
    const x = Math.round(area.x * ratio);
    const y = Math.round((this.height - area.y - area.height) * ratio);
    return [x, y, Math.round(area.width * ratio), Math.round(area.height * ratio)];
  }

  private pane(pane: PaneScene, scene: Scene, parts: Parts): void {
    const { gl, ratio } = this;
    const { camera, palette } = scene;
    const { rgb } = palette;
    const view = [camera.x, camera.y, (2 * camera.s) / pane.area.width, (2 * camera.s) / pane.area.height] as const;
    gl.viewport(...this.box(pane.area));
    gl.scissor(...this.box(pane.clip));
    gl.clearColor(rgb.unk[0], rgb.unk[1], rgb.unk[2], 1);
    gl.clear(gl.COLOR_BUFFER_BIT);
    for (const grid of pane.grids) parts.grid.draw(grid, camera, pane.area, view, palette);
    const line = (buffer: GlBuffer, segments: number, apart: 2 | 4, style: Parameters<GlLines['draw']>[3]): void =>
      parts.lines.draw(buffer, segments, apart, style, camera.s, ratio, view);
    if (pane.crosses) {
      const crosses = crossSegments(camera, pane.area);
      parts.crosses.write(crosses, crosses.length);
      line(parts.crosses, crosses.length / 4, 4, { colour: rgb.cross, alpha: 1, widthPx: 1 });
    }
    if (pane.truth) line(parts.walls, scene.walls.length / 4, 4, { colour: rgb.ink3, alpha: 0.7, widthPx: 1, dash: [1, 2.5] });
    if (pane.laser) this.laser(scene, parts, view);
    if (pane.path) line(parts.path, scene.pathLength / 2 - 1, 2, { colour: rgb.accent, alpha: 0.55, widthPx: 1.5 });
    for (const layer of pane.points) {
      if (!layer.bounds) continue;
      parts.points.drawBounds(layer, camera.s, ratio, view, palette);
      const ellipses = ellipticBounds(layer.map, layer.everyNth, scene.arcOf);
      if (ellipses.length === 0) continue;
      parts.ellipses.write(ellipses, ellipses.length);
      line(parts.ellipses, ellipses.length / 4, 4, { colour: rgb[slotColour[layer.slot]], alpha: boundAlpha(palette.dark) * layer.alpha, widthPx: boundWidth(camera.s) });
    }
    for (const layer of [...pane.points].reverse()) parts.points.drawMarks(layer, camera.s, ratio, view, palette, scene.centerlineLabel);
  }

  /** Dots as segments of no length: a square of 1.2 px cannot be told from a disc. */
  private laser(scene: Scene, parts: Parts, view: readonly number[]): void {
    const dots = new Float32Array(2 * scene.laser.length);
    const half = 0.6 / scene.camera.s;
    for (let i = 0; i + 1 < scene.laser.length; i += 2) {
      const x = scene.laser[i] ?? 0;
      const y = scene.laser[i + 1] ?? 0;
      dots.set([x - half, y, x + half, y], 2 * i);
    }
    parts.laser.write(dots, dots.length);
    parts.lines.draw(parts.laser, dots.length / 4, 4, { colour: scene.palette.rgb.ink3, alpha: 1, widthPx: 1.2 }, scene.camera.s, this.ratio, view);
  }

  destroy(): void {
    this.canvas.removeEventListener('webglcontextlost', this.lost);
    this.canvas.removeEventListener('webglcontextrestored', this.restored);
    this.parts?.grid.destroy();
    this.parts?.points.destroy();
    this.parts = null;
  }
}

/** Browsers do not all admit the caveat. */
function isSoftware(gl: WebGL2RenderingContext): boolean {
  const info = gl.getExtension('WEBGL_debug_renderer_info');
  const name = String(gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER));
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name);
}
