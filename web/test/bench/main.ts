// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Draws a map of 2048 x 2048 cells with 20,000 points while both change, as fast as the browser lets it. */
import { createMapView, type RendererChoice } from '../../src/map/map_view.ts';
import { MapStore, tileSide } from '../../src/model/map_store.ts';
import { createModel } from '../../src/model/page_model.ts';

const side = 2048 / tileSide;
const cellM = 0.05;
const points = 20_000;
const tilesPerFrame = 8;
const pointsPerFrame = 50;

const grid = new MapStore('evidence');
grid.grid = { cellM, x: 0, y: 0 };
const atm = new MapStore('atm');

function tile(column: number, row: number): void {
  const bytes = new Uint8Array(tileSide * tileSide);
  for (let k = 0; k < bytes.length; k++) bytes[k] = Math.random() < 0.05 ? 250 : 20 + 60 * Math.random();
  grid.setTile(column, row, bytes);
}

function point(slot: number): void {
  const [x, y] = [side * tileSide * cellM * Math.random(), side * tileSide * cellM * Math.random()];
  atm.setPoint({ slot, x, y, boundM: 0.1, arcX: x - 2, arcY: y, probability: 1, time: 0, ping: slot, sensor: 0, label: 0, flags: 0, support: 3 });
}

for (let r = 0; r < side; r++) for (let c = 0; c < side; c++) tile(c, r);
for (let i = 0; i < points; i++) point(i);

const model = createModel();
Object.defineProperty(model, 'maps', { value: new Map([['evidence', grid], ['atm', atm]]) });
Object.defineProperty(model, 'methods', {
  value: { type: 'methods', running: ['evidence', 'atm'].map((method) => ({ method, name: method, label: method, options: {}, state: 'ok', reason: '', grid: null, points: method === 'atm' })) },
});
model.show({ shown: ['atm', 'evidence'] });
const host = document.querySelector<HTMLElement>('#map');
if (!host) throw new Error('There is no map.');
const map = createMapView(host, model, (new URLSearchParams(location.search).get('renderer') ?? 'auto') as RendererChoice);

/** Frames per second over so many seconds at a scale, with every frame changing tiles, points and the camera. */
async function measure(s: number, seconds: number): Promise<{ framesPerS: number; p95Ms: number; accelerated: boolean }> {
  model.show({ camera: { x: 51.2, y: 51.2, s } });
  await new Promise((resolve) => setTimeout(resolve, 1500));
  const gaps: number[] = [];
  let last = performance.now();
  const begin = last;
  while (performance.now() - begin < 1000 * seconds) {
    for (let i = 0; i < tilesPerFrame; i++) tile(Math.floor(side * Math.random()), Math.floor(side * Math.random()));
    for (let i = 0; i < pointsPerFrame; i++) point(Math.floor(points * Math.random()));
    map.pan(gaps.length % 2 === 0 ? 3 : -3, 0);
    await new Promise((resolve) => requestAnimationFrame(resolve));
    const now = performance.now();
    gaps.push(now - last);
    last = now;
  }
  gaps.sort((a, b) => a - b);
  return { framesPerS: gaps.length / ((last - begin) / 1000), p95Ms: gaps[Math.floor(0.95 * gaps.length)] ?? 0, accelerated: map.accelerated };
}

Object.assign(window, { measure, map });
