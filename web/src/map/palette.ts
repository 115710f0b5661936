// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

import type { Rgb } from './ramp.ts';

const names = [
  'unk', 'free', 'occ', 'cross', 'hit', 'none', 'rej', 'atm', 'carve', 'center', 'ink', 'ink2', 'ink3', 'surface', 'accent', 'accent-ink',
  'line2', 'fuller', 'emptier', 'warn',
] as const;
export type ColourName = (typeof names)[number];

export interface Palette { css: Record<ColourName, string>; rgb: Record<ColourName, Rgb>; dark: boolean; font: string }

/** Colours of the design's tokens, as the style sheet has them now. */
export function readPalette(element: Element): Palette {
  const style = getComputedStyle(element);
  const css = {} as Record<ColourName, string>;
  const rgb = {} as Record<ColourName, Rgb>;
  for (const name of names) {
    css[name] = style.getPropertyValue(`--${name}`).trim() || '#808080';
    rgb[name] = parseHex(css[name]);
  }
  return { css, rgb, dark: luminance(rgb.free) < 0.5, font: style.fontFamily };
}

export function parseHex(hex: string): Rgb {
  const digits = /^#([0-9a-f]{6})$/i.exec(hex)?.[1] ?? '808080';
  const value = Number.parseInt(digits, 16);
  return [(value >> 16) / 255, ((value >> 8) & 255) / 255, (value & 255) / 255];
}

const luminance = ([r, g, b]: Rgb): number => 0.2126 * r + 0.7152 * g + 0.0722 * b;

export function withAlpha(colour: Rgb, alpha: number): string {
  return `rgba(${Math.round(255 * colour[0])},${Math.round(255 * colour[1])},${Math.round(255 * colour[2])},${alpha})`;
}
