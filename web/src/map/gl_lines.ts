// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Segments of an even width in pixels, dashed if wanted, and round dots. */
import { GlBuffer, GlProgram, viewGlsl } from './gl_program.ts';
import type { Rgb } from './ramp.ts';

const vertex = `${viewGlsl}
uniform vec4 u_size; // half width px, scale px/m, 2 px in clip space x, y
in vec2 a_from, a_to;
out vec2 v_at;
out float v_length;
void main() {
  vec2 along = (a_to - a_from) * u_size.y;
  float l = length(along);
  vec2 d = l > 0.0 ? along / l : vec2(1.0, 0.0);
  float end = float(gl_VertexID & 1), side = float(gl_VertexID >> 1) * 2.0 - 1.0;
  float reach = u_size.x + 1.0;
  v_at = vec2(end * l, side * reach);
  v_length = l;
  gl_Position = clip(mix(a_from, a_to, end)) + vec4(vec2(-d.y, d.x) * side * reach * u_size.zw, 0.0, 0.0);
}`;
const fragment = `
uniform vec4 u_size;
uniform vec4 u_colour;
uniform vec3 u_dash; // on px, off px, one device pixel in px
in vec2 v_at;
in float v_length;
out vec4 colour;
void main() {
  float a = clamp(0.5 + (u_size.x - abs(v_at.y)) / u_dash.z, 0.0, 1.0) * u_colour.a;
  if (u_dash.y > 0.0) {
    float at = mod(v_at.x, u_dash.x + u_dash.y);
    a *= clamp(0.5 + (u_dash.x - at) / u_dash.z, 0.0, 1.0);
  }
  if (a <= 0.0) discard;
  colour = vec4(u_colour.rgb * a, a);
}`;

export interface LineStyle { colour: Rgb; alpha: number; widthPx: number; dash?: readonly [number, number] }

export class GlLines {
  private readonly program: GlProgram;
  private readonly arrays = new Map<GlBuffer, WebGLVertexArrayObject>();

  constructor(private readonly gl: WebGL2RenderingContext) { this.program = new GlProgram(gl, vertex, fragment); }

  /** `floatsApart`: 4 for segments x0, y0, x1, y1; 2 for a polyline. */
  draw(buffer: GlBuffer, segments: number, floatsApart: 2 | 4, style: LineStyle, s: number, ratio: number, view: readonly number[]): void {
    if (segments <= 0) return;
    const { gl, program } = this;
    program.use();
    gl.bindVertexArray(this.layout(buffer, floatsApart));
    program.set('u_view', ...view);
    program.set('u_size', style.widthPx / 2, s, (view[2] ?? 0) / s, (view[3] ?? 0) / s);
    program.set('u_dash', style.dash?.[0] ?? 0, style.dash?.[1] ?? 0, 1 / ratio);
    program.set('u_colour', ...style.colour, style.alpha);
    gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, segments);
  }

  private layout(buffer: GlBuffer, floatsApart: number): WebGLVertexArrayObject {
    const known = this.arrays.get(buffer);
    if (known) return known;
    const { gl } = this;
    const array = gl.createVertexArray();
    gl.bindVertexArray(array);
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer.buffer);
    for (const [name, offset] of [['a_from', 0], ['a_to', 8]] as const) {
      const place = gl.getAttribLocation(this.program.program, name);
      gl.enableVertexAttribArray(place);
      gl.vertexAttribPointer(place, 2, gl.FLOAT, false, 4 * floatsApart, offset);
      gl.vertexAttribDivisor(place, 1);
    }
    this.arrays.set(buffer, array);
    return array;
  }
}
