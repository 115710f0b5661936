// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Programs and their uniforms; names are looked up once. */
export class GlProgram {
  readonly program: WebGLProgram;
  private readonly places = new Map<string, WebGLUniformLocation | null>();

  constructor(private readonly gl: WebGL2RenderingContext, vertex: string, fragment: string) {
    const program = gl.createProgram();
    for (const [kind, source] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]] as const) {
      const shader = gl.createShader(kind);
      if (!shader) throw new Error('The graphics context was lost.');
      gl.shaderSource(shader, `#version 300 es\nprecision highp float;\nprecision highp sampler2DArray;\n${source}`);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost()) {
      throw new Error(`A shader does not link: ${gl.getProgramInfoLog(program)}`);
    }
    this.program = program;
  }

  use(): void { this.gl.useProgram(this.program); }

  place(name: string): WebGLUniformLocation | null {
    let place = this.places.get(name);
    if (place === undefined) {
      place = this.gl.getUniformLocation(this.program, name);
      this.places.set(name, place);
    }
    return place;
  }

  set(name: string, ...values: number[]): void {
    const place = this.place(name);
    if (values.length === 1) this.gl.uniform1f(place, values[0] ?? 0);
    else if (values.length === 2) this.gl.uniform2f(place, values[0] ?? 0, values[1] ?? 0);
    else if (values.length === 3) this.gl.uniform3f(place, values[0] ?? 0, values[1] ?? 0, values[2] ?? 0);
    else this.gl.uniform4f(place, values[0] ?? 0, values[1] ?? 0, values[2] ?? 0, values[3] ?? 0);
  }

  setInt(name: string, value: number): void { this.gl.uniform1i(this.place(name), value); }
}

/** World to clip space: (centre x, centre y, 2 s / width, 2 s / height). */
export const viewGlsl = 'uniform vec4 u_view; vec4 clip(vec2 p) { return vec4((p - u_view.xy) * u_view.zw, 0.0, 1.0); }\n';

/** A vertex buffer that keeps its size while it suffices. */
export class GlBuffer {
  readonly buffer: WebGLBuffer;
  private bytes = 0;

  constructor(private readonly gl: WebGL2RenderingContext) { this.buffer = gl.createBuffer(); }

  write(data: ArrayBufferView, count: number): void {
    const { gl } = this;
    const each = (data as Uint8Array).BYTES_PER_ELEMENT;
    gl.bindBuffer(gl.ARRAY_BUFFER, this.buffer);
    if (count * each > this.bytes) {
      this.bytes = Math.max(4096, 2 ** Math.ceil(Math.log2(count * each)));
      gl.bufferData(gl.ARRAY_BUFFER, this.bytes, gl.DYNAMIC_DRAW);
    }
    gl.bufferSubData(gl.ARRAY_BUFFER, 0, data, 0, count);
  }

  destroy(): void { this.gl.deleteBuffer(this.buffer); }
}
