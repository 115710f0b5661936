// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Cells: one quad per tile, its bytes a layer of a texture array, its tone from the ramp. */
import { tileSide } from '../model/map_store.ts';
import type { MethodMap, Tile } from '../model/method_map.ts';
import type { Camera } from '../model/model.ts';
import { onCellsOf } from './blended.ts';
import type { Area } from './camera.ts';
import { GlBuffer, GlProgram, viewGlsl } from './gl_program.ts';
import { type Resident, TileTexture } from './gl_tiles.ts';
import type { ColourName, Palette } from './palette.ts';
import { filterable, freeSpan, occupiedSpan } from './ramp.ts';
import { type GridLayer, nearestFromScale } from './scene.ts';

const vertex = `${viewGlsl}
uniform vec3 u_grid; // origin and side of a tile, metres
in vec4 a_tile;      // column, row, layer of the grid and of the one it is blended with; -1: none
out vec4 v_at;
void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  v_at = vec4(corner, a_tile.zw);
  gl_Position = clip(u_grid.xy + (a_tile.xy + corner) * u_grid.z);
}`;
/** Colours of a blend are those of `blendedColour`. */
const fragment = `
uniform sampler2DArray u_tiles, u_others;
uniform vec3 u_unknown, u_free, u_occupied, u_fuller, u_emptier;
uniform vec3 u_share; // tone, alpha, blend or -1
in vec4 v_at;
out vec4 colour;
vec2 ramp(float byte) { // free, occupied
  float p = byte < 0.0 ? 0.5 : (byte * 255.0 - 1.0) / 254.0;
  float o = clamp((p - 0.5) / ${occupiedSpan}, 0.0, 1.0);
  return vec2(clamp((0.5 - p) / ${freeSpan}, 0.0, 1.0), o * o);
}
vec3 tone(vec2 r) { return mix(mix(u_unknown, u_free, r.x), u_occupied, r.y); }
void main() {
  vec2 a = ramp(v_at.z < 0.0 ? -1.0 : texture(u_tiles, v_at.xyz).r);
  vec3 c = tone(vec2(a.x, a.y * u_share.x));
  if (u_share.z >= 0.0) {
    vec2 b = ramp(v_at.w < 0.0 ? -1.0 : texture(u_others, v_at.xyw).r);
    vec3 ground = mix(u_unknown, u_free, max(a.x, b.x));
    vec3 both = ground * (1.0 - max(a.y, b.y)) + u_occupied * min(a.y, b.y) + u_fuller * max(0.0, a.y - b.y) + u_emptier * max(0.0, b.y - a.y);
    c = mix(mix(tone(a), both, min(1.0, 2.0 * u_share.z)), tone(b), max(0.0, 2.0 * u_share.z - 1.0));
  }
  colour = vec4(c, 1.0) * u_share.y;
}`;

/** Milliseconds of a frame that uploads may take; eight tiles go up in any case. */
const uploadMs = 5;
const uploadLeast = 8;
const colours: readonly [string, ColourName][] = [['u_unknown', 'unk'], ['u_free', 'free'], ['u_occupied', 'occ'], ['u_fuller', 'fuller'], ['u_emptier', 'emptier']];

interface Bound { map: MethodMap; texture: TileTexture }
interface Seen { c0: number; c1: number; r0: number; r1: number }

function seenTiles(camera: Camera, area: Area, { x, y }: { x: number; y: number }, side: number): Seen {
  const halfX = area.width / 2 / camera.s;
  const halfY = area.height / 2 / camera.s;
  return {
    c0: Math.floor((camera.x - halfX - x) / side), c1: Math.floor((camera.x + halfX - x) / side),
    r0: Math.floor((camera.y - halfY - y) / side), r1: Math.floor((camera.y + halfY - y) / side),
  };
}

export class GlGrid {
  private readonly program: GlProgram;
  private readonly instances: GlBuffer;
  private readonly array: WebGLVertexArrayObject;
  private readonly textures = new Map<string, TileTexture>();
  private readonly bytes = new Uint8Array(tileSide * tileSide);
  private data = new Float32Array(4 * 256);
  private readonly layerLimit: number;
  private frame = 0;
  private uploaded = 0;
  private beginMs = 0;
  /** Tiles that are seen but not yet, or not in their newest form, on the card. */
  late = 0;

  constructor(private readonly gl: WebGL2RenderingContext) {
    this.program = new GlProgram(gl, vertex, fragment);
    this.instances = new GlBuffer(gl);
    this.array = gl.createVertexArray();
    this.layerLimit = gl.getParameter(gl.MAX_ARRAY_TEXTURE_LAYERS) as number;
    gl.bindVertexArray(this.array);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.instances.buffer);
    const place = gl.getAttribLocation(this.program.program, 'a_tile');
    gl.enableVertexAttribArray(place);
    gl.vertexAttribPointer(place, 4, gl.FLOAT, false, 16, 0);
    gl.vertexAttribDivisor(place, 1);
  }

  begin(): void {
    this.frame++;
    this.uploaded = 0;
    this.late = 0;
    this.beginMs = performance.now();
  }

  draw({ map, tone, alpha, against }: GridLayer, camera: Camera, area: Area, view: readonly number[], palette: Palette): void {
    const other = against ? onCellsOf(against.map, map) : null;
    if (!map.grid || map.tiles.size + (other?.tiles.size ?? 0) === 0 || alpha <= 0) return;
    const { gl, program } = this;
    const own = { map, texture: this.bind(map, gl.TEXTURE0, camera.s) };
    const partner = other && { map: other, texture: this.bind(other, gl.TEXTURE1, camera.s) };
    const side = map.grid.cellM * tileSide;
    const count = this.gather(own, partner, seenTiles(camera, area, map.grid, side));
    if (count === 0) return;
    program.use();
    this.instances.write(this.data, 4 * count);
    gl.bindVertexArray(this.array);
    program.setInt('u_tiles', 0);
    program.setInt('u_others', partner ? 1 : 0);
    program.set('u_view', ...view);
    program.set('u_grid', map.grid.x, map.grid.y, side);
    for (const [uniform, name] of colours) program.set(uniform, ...palette.rgb[name]);
    program.set('u_share', tone, alpha, against?.blend ?? -1);
    gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, count);
    gl.activeTexture(gl.TEXTURE0);
  }

  private bind(map: MethodMap, unit: number, s: number): TileTexture {
    const { gl } = this;
    const texture = this.textures.get(map.method) ?? new TileTexture(gl, this.layerLimit);
    this.textures.set(map.method, texture);
    gl.activeTexture(unit);
    texture.reserve(map.tiles.size);
    if (texture.residents.size > map.tiles.size) texture.drop(map.tiles);
    gl.bindTexture(gl.TEXTURE_2D_ARRAY, texture.texture);
    const filter = s < nearestFromScale ? gl.LINEAR : gl.NEAREST;
    gl.texParameteri(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_MAG_FILTER, filter);
    gl.texParameteri(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_MIN_FILTER, filter);
    return texture;
  }

  /** Tiles that are seen, of either grid, uploaded as far as the frame's time goes; returns how many can be drawn. */
  private gather(own: Bound, other: Bound | null, { c0, c1, r0, r1 }: Seen): number {
    let count = 0;
    const add = (key: string, { column, row }: Tile): void => {
      if (column < c0 || column > c1 || row < r0 || row > r1) return;
      const layer = this.layerOf(own, key, this.gl.TEXTURE0);
      const second = other ? this.layerOf(other, key, this.gl.TEXTURE1) : -1;
      if (layer < 0 && second < 0) return;
      if (4 * count + 4 > this.data.length) this.grow();
      this.data.set([column, row, layer, second], 4 * count);
      count++;
    };
    for (const [key, tile] of own.map.tiles) add(key, tile);
    if (other) for (const [key, tile] of other.map.tiles) if (!own.map.tiles.has(key)) add(key, tile);
    return count;
  }

  /** Where a tile is on the card; -1 where there is none, or it must wait. */
  private layerOf({ map, texture }: Bound, key: string, unit: number): number {
    const tile = map.tiles.get(key);
    const resident = tile && texture.layerFor(key, this.frame);
    if (!tile || !resident) return -1;
    resident.seen = this.frame;
    this.gl.activeTexture(unit);
    if (resident.tile !== tile && !this.upload(tile, resident) && !resident.tile) return -1;
    return resident.layer;
  }

  private grow(): void {
    const larger = new Float32Array(2 * this.data.length);
    larger.set(this.data);
    this.data = larger;
  }

  private upload(tile: Tile, resident: Resident): boolean {
    if (this.uploaded >= uploadLeast && performance.now() - this.beginMs > uploadMs) {
      this.late++;
      return false;
    }
    const { gl } = this;
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
    gl.texSubImage3D(gl.TEXTURE_2D_ARRAY, 0, 0, 0, resident.layer, tileSide, tileSide, 1, gl.RED, gl.UNSIGNED_BYTE, filterable(tile.bytes, this.bytes));
    resident.tile = tile;
    this.uploaded++;
    return true;
  }

  destroy(): void {
    for (const texture of this.textures.values()) texture.destroy();
    this.instances.destroy();
  }
}
