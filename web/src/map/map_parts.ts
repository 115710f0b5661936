// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** What the map is put together from: its canvases, its renderer and the walls as segments. */
import { CanvasRenderer } from './canvas_renderer.ts';
import { GlRenderer } from './gl_renderer.ts';
import type { RendererChoice } from './map_view.ts';
import type { GroundRenderer } from './scene.ts';

export function makeGround(host: HTMLElement, renderer: RendererChoice, again: () => void): GroundRenderer {
  const canvas = makeCanvas(host, 'map-canvas');
  const gl = renderer === 'canvas2d' ? null : GlRenderer.make(canvas, renderer === 'webgl2', again);
  if (gl) return gl;
  // A canvas that gave a context of one kind gives none of another.
  canvas.remove();
  return new CanvasRenderer(makeCanvas(host, 'map-canvas'));
}

export function makeCanvas(host: HTMLElement, className: string): HTMLCanvasElement {
  const canvas = document.createElement('canvas');
  canvas.className = className;
  canvas.setAttribute('aria-hidden', 'true');
  host.append(canvas);
  return canvas;
}

/** All canvases of the map over one another, as PNG. */
export function pictureOf(host: HTMLElement, width: number, height: number): Promise<Blob> {
  const both = document.createElement('canvas');
  both.width = width;
  both.height = height;
  const g = both.getContext('2d');
  for (const canvas of host.querySelectorAll<HTMLCanvasElement>('canvas.map-canvas')) g?.drawImage(canvas, 0, 0);
  return new Promise((resolve, reject) => both.toBlob((blob) => (blob ? resolve(blob) : reject(new Error('The map is too large for a picture.')))));
}

export function wallSegments(walls: readonly (readonly (readonly number[])[])[]): Float32Array<ArrayBuffer> {
  const out: number[] = [];
  for (const wall of walls) {
    for (let i = 0; i + 1 < wall.length; i++) out.push(wall[i]?.[0] ?? 0, wall[i]?.[1] ?? 0, wall[i + 1]?.[0] ?? 0, wall[i + 1]?.[1] ?? 0);
  }
  return new Float32Array(out);
}
