// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** The tiles of one method on the graphics card: layers of a texture array. */
import { tileSide } from '../model/map_store.ts';
import type { Tile } from '../model/method_map.ts';

const firstLayers = 64;

/** `tile`: what was uploaded; versions of two maps of one method, now and before a ping, may be the same. */
export interface Resident { layer: number; tile: Tile | null; seen: number }

export class TileTexture {
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
    const made: Resident = { layer, tile: null, seen: frame };
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
