// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** The map of one method as it came over the wire: tiles of bytes, and points in slots that stay where they are. */
export interface Tile { column: number; row: number; /** 64 x 64, rows from below; see docs/protocol.md */ bytes: Uint8Array; version: number }

export interface MethodMap {
  /** Id of the running method. */
  readonly method: string;
  /** The method's name in the catalogue. */
  readonly name: string;
  /** Null for methods without cells. */
  readonly grid: { cellM: number; x: number; y: number } | null;
  readonly tiles: ReadonlyMap<string, Tile>;
  /** Number of slots in use or free; arrays below are at least that long. */
  readonly slots: number;
  readonly alive: Uint8Array;
  readonly x: Float32Array;
  readonly y: Float32Array;
  readonly boundM: Float32Array;
  /** Centre of the arc the point lies on; NaN where there is none. */
  readonly arcX: Float32Array;
  readonly arcY: Float32Array;
  readonly probability: Float32Array;
  readonly time: Float32Array;
  readonly ping: Uint32Array;
  readonly sensor: Uint16Array;
  readonly label: Uint8Array;
  readonly flags: Uint8Array;
  readonly support: Uint32Array;
  readonly points: number;
  /** Grows with every change. */
  readonly version: number;
}
