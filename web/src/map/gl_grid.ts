// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Cells: one quad per tile, its bytes a layer of a texture array, its tone from the ramp. */
import { tileSide } from '../model/map_store.ts';
import type { Tile } from '../model/method_map.ts';
import type { Camera } from '../model/model.ts';
import type { Area } from './camera.ts';
import { GlBuffer, GlProgram, viewGlsl } from './gl_program.ts';
import type { Palette } from './palette.ts';
import { filterable, freeSpan, occupiedSpan } from './ramp.ts';
import { type GridLayer, nearestFromScale } from './scene.ts';

const vertex = `${viewGlsl}
uniform vec3 u_grid; // origin and side of a tile, metres
in vec3 a_tile;      // column, row, layer
out vec3 v_at;
void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  v_at = vec3(corner, a_tile.z);
  gl_Position = clip(u_grid.xy + (a_tile.xy + corner) * u_grid.z);
}`;
const fragment = `
uniform sampler2DArray u_tiles;
uniform vec3 u_unknown, u_free, u_occupied;
uniform vec2 u_share; // tone, alpha
in vec3 v_at;
out vec4 colour;
void main() {
  float p = (texture(u_tiles, v_at).r * 255.0 - 1.0) / 254.0;
  float f = clamp((0.5 - p) / ${freeSpan}, 0.0, 1.0);
  float o = clamp((p - 0.5) / ${occupiedSpan}, 0.0, 1.0);
  vec3 c = mix(mix(u_unknown, u_free, f), u_occupied, o * o * u_share.x);
  colour = vec4(c, 1.0) * u_share.y;
}`;

/** Milliseconds of a frame that uploads may take; eight tiles go up in any case. */
const uploadMs = 5;
const uploadLeast = 8;
const firstLayers = 64;

interface Resident { layer: number; version: number; seen: number }

/** The tiles of one method on the graphics card. */
class TileTexture {
  readonly residents = new Map<string, Resident>();
  texture: WebGLTexture | null = null;
  capacity = 0;
  private free: number[] = [];

  constructor(private readonly gl: WebGL2RenderingContext, private readonly limit: number) {}

  /** Room for so many tiles; growing forgets what is there, it is uploaded anew. */
  reserve(tiles: number): void {
    const wanted = Math.min(this.limit, Math.max(firstLayers, 2 ** Math.ceil(Math.log2(Math.max(1, tiles)))));
    if (wanted <= this.capacity) return;
    const { gl } = this;
    gl.deleteTexture(this.texture);
    this.texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D_ARRAY, this.texture);
    gl.texStorage3D(gl.TEXTURE_2D_ARRAY, 1, gl.R8, tileSide, tileSide, wanted);
    gl.texParameteri(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
    gl.texParameteri(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
    this.capacity = wanted;
    this.residents.clear();
    this.free = Array.from({ length: wanted }, (_, i) => wanted - 1 - i);
  }

  /** A layer for a tile; one that is not seen in this frame gives way. */
  layerFor(key: string, frame: number): Resident | null {
    const known = this.residents.get(key);
    if (known) return known;
    let layer = this.free.pop();
    if (layer === undefined) {
      for (const [old, resident] of this.residents) {
        if (resident.seen === frame) continue;
        this.residents.delete(old);
        layer = resident.layer;
        break;
      }
    }
    if (layer === undefined) return null;
    const made = { layer, version: -1, seen: frame };
    this.residents.set(key, made);
    return made;
  }

  drop(known: ReadonlyMap<string, Tile>): void {
    for (const [key, resident] of this.residents) {
      if (known.has(key)) continue;
      this.residents.delete(key);
      this.free.push(resident.layer);
    }
  }

  destroy(): void { this.gl.deleteTexture(this.texture); }
}

export class GlGrid {
  private readonly program: GlProgram;
  private readonly instances: GlBuffer;
  private readonly array: WebGLVertexArrayObject;
  private readonly textures = new Map<string, TileTexture>();
  private readonly bytes = new Uint8Array(tileSide * tileSide);
  private data = new Float32Array(3 * 256);
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
    gl.vertexAttribPointer(place, 3, gl.FLOAT, false, 12, 0);
    gl.vertexAttribDivisor(place, 1);
  }

  begin(): void {
    this.frame++;
    this.uploaded = 0;
    this.late = 0;
    this.beginMs = performance.now();
  }

  draw({ map, tone, alpha }: GridLayer, camera: Camera, area: Area, view: readonly number[], palette: Palette): void {
    if (!map.grid || map.tiles.size === 0 || alpha <= 0) return;
    const { gl, program } = this;
    const texture = this.textures.get(map.method) ?? new TileTexture(gl, this.layerLimit);
    this.textures.set(map.method, texture);
    texture.reserve(map.tiles.size);
    if (texture.residents.size > map.tiles.size) texture.drop(map.tiles);
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D_ARRAY, texture.texture);
    const filter = camera.s < nearestFromScale ? gl.LINEAR : gl.NEAREST;
    gl.texParameteri(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_MAG_FILTER, filter);
    gl.texParameteri(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_MIN_FILTER, filter);
    const side = map.grid.cellM * tileSide;
    const count = this.gather(map.tiles, texture, camera, area, map.grid.x, map.grid.y, side);
    if (count === 0) return;
    program.use();
    this.instances.write(this.data, 3 * count);
    gl.bindVertexArray(this.array);
    program.setInt('u_tiles', 0);
    program.set('u_view', ...view);
    program.set('u_grid', map.grid.x, map.grid.y, side);
    program.set('u_unknown', ...palette.rgb.unk);
    program.set('u_free', ...palette.rgb.free);
    program.set('u_occupied', ...palette.rgb.occ);
    program.set('u_share', tone, alpha);
    gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, count);
  }

  /** Tiles that are seen, uploaded as far as the frame's time goes; returns how many can be drawn. */
  private gather(tiles: ReadonlyMap<string, Tile>, texture: TileTexture, camera: Camera, area: Area, x: number, y: number, side: number): number {
    const halfX = area.width / 2 / camera.s;
    const halfY = area.height / 2 / camera.s;
    const [c0, c1] = [Math.floor((camera.x - halfX - x) / side), Math.floor((camera.x + halfX - x) / side)];
    const [r0, r1] = [Math.floor((camera.y - halfY - y) / side), Math.floor((camera.y + halfY - y) / side)];
    let count = 0;
    for (const [key, tile] of tiles) {
      if (tile.column < c0 || tile.column > c1 || tile.row < r0 || tile.row > r1) continue;
      const resident = texture.layerFor(key, this.frame);
      if (!resident) continue;
      resident.seen = this.frame;
      if (resident.version !== tile.version && !this.upload(tile, resident) && resident.version < 0) continue;
      if (3 * count + 3 > this.data.length) this.grow();
      this.data[3 * count] = tile.column;
      this.data[3 * count + 1] = tile.row;
      this.data[3 * count + 2] = resident.layer;
      count++;
    }
    return count;
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
    resident.version = tile.version;
    this.uploaded++;
    return true;
  }

  destroy(): void {
    for (const texture of this.textures.values()) texture.destroy();
    this.instances.destroy();
  }
}
