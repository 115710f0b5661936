// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Which maps, layers and panes the view asks for. */
import type { MethodMap } from '../model/method_map.ts';
import type { Model } from '../model/model.ts';
import type { Area, Box } from './camera.ts';
import { paleTone } from './ramp.ts';
import { boundsFromScale, type GridLayer, type PaneScene, type PointLayer } from './scene.ts';
import { markSlots } from './slots.ts';

/** Cells that change are drawn over the others, so these are paler in step mode. */
const stepTone = 0.6;
const manyPoints = 50_000;
const thinBelowScale = 34;
const mostPoints = 4;
/** Points beyond which bounds are left out where drawing is dear. */
const slowBoundsFrom = 5000;

export interface SceneWish {
  model: Model;
  maps: ReadonlyMap<string, MethodMap>;
  /** Method whose step is shown; null: none. */
  stepped: string | null;
  width: number;
  height: number;
  s: number;
  slow: boolean;
}

export function isPoints(model: Model, method: string): boolean {
  return model.methods?.running.find((r) => r.method === method)?.points ?? false;
}

export function everyNth(points: number, s: number): number {
  return points > manyPoints && s < thinBelowScale ? Math.ceil(points / manyPoints) : 1;
}

export function comparedMethods(model: Model): string[] {
  const { mode, methods } = model.view.compare;
  const running = (model.methods?.running ?? []).map((r) => r.method);
  const chosen = methods.filter((m) => running.includes(m));
  return (chosen.length > 0 ? chosen : running).slice(0, mode === 'side' ? 4 : 2);
}

const narrowPx = 520;
/** Phones have two panes, one below the other. */
export const mostPanes = (width: number): number => (width < narrowPx ? 2 : 4);

/** 1; 1|1; 2 x 2, with a hairline between. */
export function sideAreas(count: number, width: number, height: number, most = 4): Area[] {
  const columns = count > 1 && most > 2 ? 2 : 1;
  const rows = Math.ceil(count / columns);
  const [w, h] = [width / columns, height / rows];
  return Array.from({ length: count }, (_, i) => ({ x: (i % columns) * w, y: Math.floor(i / columns) * h, width: w, height: h }));
}

export function buildPanes(wish: SceneWish): PaneScene[] {
  const { model, width, height } = wish;
  const whole = { x: 0, y: 0, width, height };
  if (model.view.name !== 'compare') return [mapPane(wish, whole)];
  const methods = comparedMethods(model).slice(0, mostPanes(width));
  const { mode, blend, swipe } = model.view.compare;
  if (mode === 'side') return sideAreas(methods.length, width, height, mostPanes(width)).map((area, i) => comparePane(wish, area, area, [methods[i] ?? ''], [1]));
  if (mode === 'blend') return [withBlend(comparePane(wish, whole, whole, methods, [Math.min(1, 2 * (1 - blend)), Math.min(1, 2 * blend)]), methods, blend)];
  const at = Math.round(width * swipe);
  const clips = [{ ...whole, width: at }, { ...whole, x: at, width: width - at }];
  return methods.map((method, i) => comparePane(wish, whole, clips[i] ?? whole, [method], [1]));
}

/** Of two grids a blend by opacity would show neither: what both hold and what one holds alone is coloured instead. */
function withBlend(pane: PaneScene, methods: readonly string[], blend: number): PaneScene {
  const [first, second] = methods.map((m) => pane.grids.find((g) => g.map.method === m));
  return first && second ? { ...pane, grids: [{ map: first.map, tone: 1, alpha: 1, against: { map: second.map, blend } }] } : pane;
}

function layersOf(wish: SceneWish): Pick<PaneScene, 'crosses' | 'truth' | 'laser' | 'path'> {
  const { layers } = wish.model.view;
  const truth = layers.has('truth') && (wish.model.welcome?.source.walls.length ?? 0) > 0;
  return { crosses: true, truth, laser: layers.has('laser'), path: layers.has('path') };
}

function pointLayer(wish: SceneWish, map: MethodMap, alpha: number): PointLayer {
  const { model, s, slow } = wish;
  const slot = markSlots(model.methods, model.view.shown).get(map.method) ?? 4;
  const bounds = model.view.layers.has('bounds') && s >= boundsFromScale && !(slow && map.points > slowBoundsFrom);
  return { map, slot, alpha, bounds, everyNth: everyNth(map.points, s) };
}

function mapPane(wish: SceneWish, area: Area): PaneScene {
  const { model, maps } = wish;
  const stepping = model.view.name === 'step';
  // Step mode is about one method: its points over the first grid, or its own cells alone.
  const names = stepping ? steppedMethods(wish) : model.view.shown;
  const shown = names.map((m) => maps.get(m)).filter((m): m is MethodMap => m !== undefined);
  const points = shown.filter((m) => isPoints(model, m.method)).slice(0, mostPoints);
  const grids = shown.filter((m) => !isPoints(model, m.method));
  const tone = points.length > 0 ? paleTone : stepping ? stepTone : 1;
  return {
    area, clip: area, methods: shown.map((m) => m.method), grids: grids.map((map, i): GridLayer => ({ map, tone, alpha: i === 0 ? 1 : 0.5 })),
    points: points.map((map) => pointLayer(wish, map, 1)), ...layersOf(wish), crosses: !stepping,
  };
}

function steppedMethods({ model, stepped }: SceneWish): string[] {
  const { shown } = model.view;
  if (stepped === null || !isPoints(model, stepped)) return stepped === null ? shown : [stepped];
  const ground = shown.find((m) => !isPoints(model, m));
  return ground === undefined ? [stepped] : [stepped, ground];
}

/** Methods over the explored area alone, so that the ground favours nobody. */
function comparePane(wish: SceneWish, area: Area, clip: Area, methods: readonly string[], alphas: readonly number[]): PaneScene {
  const { model, maps } = wish;
  const own = methods.map((m, i) => ({ map: maps.get(m), alpha: alphas[i] ?? 1 })).filter((m): m is { map: MethodMap; alpha: number } => m.map !== undefined);
  const grids = own.filter(({ map }) => !isPoints(model, map.method)).map(({ map, alpha }): GridLayer => ({ map, tone: 1, alpha }));
  const points = own.filter(({ map }) => isPoints(model, map.method)).map(({ map, alpha }) => pointLayer(wish, map, alpha));
  const ground = [...maps.values()].find((m) => m.grid !== null && !isPoints(model, m.method));
  if (ground && points.length > 0) grids.unshift({ map: ground, tone: 0, alpha: 1 });
  const layers = layersOf(wish);
  return { area, clip, methods: [...methods], grids, points, ...layers, truth: (model.welcome?.source.walls.length ?? 0) > 0 && layers.truth };
}

/** Everything that is known: tiles, points, path and robot. Null while there is nothing. */
export function contentBox(model: Model): Box | null {
  const box = { x0: Infinity, y0: Infinity, x1: -Infinity, y1: -Infinity };
  const add = (x: number, y: number): void => {
    if (!Number.isFinite(x) || !Number.isFinite(y)) return;
    box.x0 = Math.min(box.x0, x);
    box.x1 = Math.max(box.x1, x);
    box.y0 = Math.min(box.y0, y);
    box.y1 = Math.max(box.y1, y);
  };
  for (const map of model.maps.values()) for (let i = 0; i < map.slots; i++) if (map.alive[i]) add(map.x[i] ?? 0, map.y[i] ?? 0);
  for (let i = 0; i + 1 < model.pathLength; i += 2) add(model.path[i] ?? 0, model.path[i + 1] ?? 0);
  for (const wall of model.welcome?.source.walls ?? []) for (const [x, y] of wall) add(x ?? Number.NaN, y ?? Number.NaN);
  if (model.state) add(model.state.pose[0], model.state.pose[1]);
  if (box.x1 < box.x0) return null;
  const least = 4; // a robot that has not moved yet is seen with its surroundings
  const grow = (low: number, high: number): [number, number] => { const add = Math.max(0, least - (high - low)) / 2; return [low - add, high + add]; };
  [box.x0, box.x1] = grow(box.x0, box.x1);
  [box.y0, box.y1] = grow(box.y0, box.y1);
  return box;
}
