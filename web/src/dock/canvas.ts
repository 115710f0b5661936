// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

export interface Drawing { context: CanvasRenderingContext2D; width: number }

/** A cleared canvas in CSS pixels; null while it is not laid out. */
export function canvasOf(canvas: HTMLCanvasElement, height: number): Drawing | null {
  const width = canvas.clientWidth;
  const context = width > 0 ? canvas.getContext('2d') : null;
  if (!context) return null;
  const ratio = Math.min(2, devicePixelRatio || 1);
  if (canvas.width !== Math.round(width * ratio)) { canvas.width = Math.round(width * ratio); canvas.height = Math.round(height * ratio); }
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, width, height);
  return { context, width };
}

export const colour = (token: string): string => getComputedStyle(document.documentElement).getPropertyValue(token).trim();
