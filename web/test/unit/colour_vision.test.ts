// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** The five data colours stay apart for every kind of colour vision, and stand out from the ground. */
import { readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { parseHex } from '../../src/map/palette.ts';

type Vector = readonly [number, number, number];
type Matrix = readonly [Vector, Vector, Vector];

/** [Machado09], severity 1, on linear RGB. */
const visions: Record<string, Matrix> = {
  normal: [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
  deutan: [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.01182, 0.04294, 0.968881]],
  protan: [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
  tritan: [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.3039]],
};
const leastDistance = 20;
const leastContrast = 3;

const linear = (c: number): number => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);
const dot = (a: Vector, b: Vector): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const rgbOf = (hex: string): Vector => parseHex(hex).map(linear) as unknown as Vector;
const seen = (vision: Matrix, v: Vector): Vector => vision.map((row) => Math.max(0, Math.min(1, dot(row, v)))) as unknown as Vector;

function lab(v: Vector): Vector {
  const f = (t: number): number => (t > 0.008856 ? Math.cbrt(t) : 7.787 * t + 16 / 116);
  const x = f(dot([0.4124, 0.3576, 0.1805], v) / 0.9505);
  const y = f(dot([0.2126, 0.7152, 0.0722], v));
  const z = f(dot([0.0193, 0.1192, 0.9505], v) / 1.089);
  return [116 * y - 16, 500 * (x - y), 200 * (y - z)];
}

function distance(vision: Matrix, a: string, b: string): number {
  const [p, q] = [lab(seen(vision, rgbOf(a))), lab(seen(vision, rgbOf(b)))];
  return Math.hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

function contrast(a: string, b: string): number {
  const [p, q] = [a, b].map((hex) => dot([0.2126, 0.7152, 0.0722], rgbOf(hex))) as [number, number];
  return (Math.max(p, q) + 0.05) / (Math.min(p, q) + 0.05);
}

/** Tokens of a theme, as the page declares them. */
function tokens(css: string, dark: boolean): Map<string, string> {
  const blocks = [...css.matchAll(/([^{}]*)\{([^{}]*)\}/g)].filter(([, selector]) => /:root|data-theme/.test(selector ?? ''));
  const own = blocks.filter(([, selector]) => (selector?.includes('dark') ?? false) === dark);
  return new Map(own.flatMap(([, , body]) => [...(body ?? '').matchAll(/--([\w-]+):\s*(#[0-9a-f]{6})\b/gi)].map((m) => [m[1] ?? '', m[2] ?? ''] as const)));
}

const css = readFileSync(new URL('../../style/tokens.css', import.meta.url), 'utf8');
const marks = ['hit', 'rej', 'atm', 'carve', 'center'];

describe.each([['light', false], ['dark', true]] as const)('%s', (_, dark) => {
  const of = tokens(css, dark);
  const colour = (name: string): string => of.get(name) ?? '';

  test('all colours are there', () => {
    for (const name of [...marks, 'free', 'unk']) expect(colour(name), name).toMatch(/^#[0-9a-f]{6}$/i);
  });

  test.each(Object.keys(visions))('%s vision tells them apart', (name) => {
    const vision = visions[name] as Matrix;
    marks.forEach((a, i) => { for (const b of marks.slice(i + 1)) expect(distance(vision, colour(a), colour(b)), `${a} and ${b}`).toBeGreaterThanOrEqual(leastDistance); });
  });

  test('they stand out from explored and unexplored ground', () => {
    for (const a of marks) for (const ground of ['free', 'unk']) expect(contrast(colour(a), colour(ground)), `${a} on ${ground}`).toBeGreaterThanOrEqual(leastContrast);
  });
});

test('the measure itself: equal colours are not apart, black and white are', () => {
  expect(distance(visions['normal'] as Matrix, '#123456', '#123456')).toBe(0);
  expect(distance(visions['normal'] as Matrix, '#000000', '#ffffff')).toBeCloseTo(100, 0);
  expect(contrast('#000000', '#ffffff')).toBeCloseTo(21, 5);
});
