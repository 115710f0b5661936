// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Marks as point sprites and bounds as instances, straight from the columns of a method's map. */
import type { MethodMap } from '../model/method_map.ts';
import { GlBuffer, GlProgram, viewGlsl } from './gl_program.ts';
import type { Palette } from './palette.ts';
import { boundAlpha, boundWidth, markRadius, type PointLayer } from './scene.ts';
import { slotColour } from './slots.ts';

const columns = ['x', 'y', 'alive', 'label', 'arcX', 'arcY', 'boundM'] as const;
type Column = (typeof columns)[number];

const pointVertex = `${viewGlsl}
uniform vec2 u_mark; // radius px, extent px
uniform float u_open_label, u_pixel;
in float a_x, a_y, a_alive, a_label;
flat out float v_open;
void main() {
  v_open = a_label == u_open_label ? 1.0 : 0.0;
  gl_PointSize = 2.0 * u_mark.y / u_pixel;
  gl_Position = a_alive < 0.5 ? vec4(2.0, 2.0, 2.0, 1.0) : clip(vec2(a_x, a_y));
}`;
const pointFragment = `
uniform vec2 u_mark;
uniform vec4 u_colour;
uniform float u_shape, u_pixel;
flat in float v_open;
out vec4 colour;
void main() {
  vec2 q = abs(2.0 * gl_PointCoord - 1.0) * u_mark.y;
  float r = u_mark.x, d;
  if (u_shape < 1.5) d = (q.x + q.y - 1.25 * r) * 0.7071;
  else if (u_shape < 2.5) d = length(q) - r;
  else if (u_shape < 3.5) d = max(max(q.x, q.y) - r, abs(q.x - q.y) * 0.7071 - max(0.55, 0.22 * r));
  else d = abs(max(q.x, q.y) - 0.85 * r) - max(0.45, 0.16 * r);
  if (v_open > 0.5 && u_shape < 2.5) d = abs(d + 0.5) - 0.5;
  float a = clamp(0.5 - d / u_pixel, 0.0, 1.0) * u_colour.a;
  if (a <= 0.0) discard;
  colour = vec4(u_colour.rgb * a, a);
}`;

const pieces = 6;
const boundVertex = `${viewGlsl}
uniform vec2 u_width; // half width in metres with the edge that fades, half of it without
in float a_x, a_y, a_alive, a_arcX, a_arcY, a_boundM;
out float v_off;
void main() {
  vec2 to = vec2(a_x - a_arcX, a_y - a_arcY);
  float r = length(to);
  bool drawn = a_alive > 0.5 && r > 0.0 && a_boundM > 0.0;
  float half_angle = 2.0 * asin(min(0.5, a_boundM / (2.0 * r)));
  float t = half_angle * (2.0 * float(gl_VertexID >> 1) / float(${pieces}) - 1.0);
  float side = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
  v_off = side * u_width.x;
  float c = cos(t), s = sin(t);
  vec2 along = vec2(c * to.x - s * to.y, s * to.x + c * to.y);
  gl_Position = drawn ? clip(vec2(a_arcX, a_arcY) + along * (1.0 + v_off / r)) : vec4(2.0, 2.0, 2.0, 1.0);
}`;
const boundFragment = `
uniform vec2 u_width;
uniform vec4 u_colour;
uniform float u_metre;
in float v_off;
out vec4 colour;
void main() {
  float a = clamp(0.5 + (u_width.y - abs(v_off)) / u_metre, 0.0, 1.0) * u_colour.a;
  colour = vec4(u_colour.rgb * a, a);
}`;

interface Uploaded { buffers: Record<Column, GlBuffer>; version: number; arrays: Map<number, WebGLVertexArrayObject>; map: MethodMap | null }

export class GlPoints {
  private readonly marks: GlProgram;
  private readonly bounds: GlProgram;
  private readonly maps = new Map<string, Uploaded>();

  constructor(private readonly gl: WebGL2RenderingContext) {
    this.marks = new GlProgram(gl, pointVertex, pointFragment);
    this.bounds = new GlProgram(gl, boundVertex, boundFragment);
  }

  drawBounds({ map, slot, everyNth, alpha }: PointLayer, s: number, ratio: number, view: readonly number[], palette: Palette): void {
    if (map.points === 0) return;
    const { gl, bounds } = this;
    const uploaded = this.upload(map);
    bounds.use();
    gl.bindVertexArray(this.layout(uploaded, bounds, everyNth, 1));
    const half = boundWidth(s) / 2 / s;
    const pixel = 1 / (s * ratio);
    bounds.set('u_view', ...view);
    bounds.set('u_width', half + pixel, half);
    bounds.set('u_metre', pixel);
    bounds.set('u_colour', ...palette.rgb[slotColour[slot]], boundAlpha(palette.dark) * alpha);
    gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 2 * pieces + 2, Math.ceil(map.slots / everyNth));
  }

  drawMarks({ map, slot, everyNth, alpha }: PointLayer, s: number, ratio: number, view: readonly number[], palette: Palette, openLabel: number): void {
    if (map.points === 0) return;
    const { gl, marks } = this;
    const uploaded = this.upload(map);
    marks.use();
    gl.bindVertexArray(this.layout(uploaded, marks, everyNth, 0));
    const radius = markRadius(s);
    const pixel = 1 / ratio;
    marks.set('u_view', ...view);
    marks.set('u_mark', radius, 1.25 * radius + pixel);
    marks.set('u_shape', slot);
    marks.set('u_pixel', pixel);
    marks.set('u_open_label', map.name === 'centerline' ? -1 : openLabel);
    marks.set('u_colour', ...palette.rgb[slotColour[slot]], alpha);
    gl.drawArrays(gl.POINTS, 0, Math.ceil(map.slots / everyNth));
  }

  private upload(map: MethodMap): Uploaded {
    let uploaded = this.maps.get(map.method);
    if (!uploaded) {
      const buffers = Object.fromEntries(columns.map((column) => [column, new GlBuffer(this.gl)])) as Record<Column, GlBuffer>;
      uploaded = { buffers, version: -1, arrays: new Map(), map: null };
      this.maps.set(map.method, uploaded);
    }
    if (uploaded.version !== map.version || uploaded.map !== map) {
      for (const column of columns) uploaded.buffers[column].write(map[column], map.slots);
      uploaded.version = map.version;
      uploaded.map = map;
    }
    return uploaded;
  }

  /** Which column feeds which attribute; every n-th point by a longer step. */
  private layout(uploaded: Uploaded, program: GlProgram, everyNth: number, divisor: 0 | 1): WebGLVertexArrayObject {
    const key = 2 * everyNth + divisor;
    const known = uploaded.arrays.get(key);
    if (known) return known;
    const { gl } = this;
    const array = gl.createVertexArray();
    gl.bindVertexArray(array);
    for (const column of columns) {
      const place = gl.getAttribLocation(program.program, `a_${column}`);
      if (place < 0) continue;
      const isByte = column === 'alive' || column === 'label';
      gl.bindBuffer(gl.ARRAY_BUFFER, uploaded.buffers[column].buffer);
      gl.enableVertexAttribArray(place);
      gl.vertexAttribPointer(place, 1, isByte ? gl.UNSIGNED_BYTE : gl.FLOAT, false, (isByte ? 1 : 4) * everyNth, 0);
      gl.vertexAttribDivisor(place, divisor);
    }
    uploaded.arrays.set(key, array);
    return array;
  }

  destroy(): void {
    for (const { buffers } of this.maps.values()) for (const column of columns) buffers[column].destroy();
  }
}
