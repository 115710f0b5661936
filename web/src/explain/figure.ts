// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Where things lie in the figure "along the arc": angles from the beam axis to places on a line. */
import type { Explanation } from '../protocol/messages.ts';

export const figureSize = { width: 312, height: 84, margin: 12, line: 44 } as const;

export interface FigureMark { ping: number; /** A crossing, or an end that a cut has left. */ kind: 'crossing' | 'cut'; x: number }

export interface ArcFigure {
  /** The angle at both ends, in radians. */
  limit: number;
  axis: number;
  /** What is left of the arc, and the whole of it. */
  left: { x0: number; x1: number };
  whole: { x0: number; x1: number };
  point: number;
  bound: { x0: number; x1: number } | null;
  marks: FigureMark[];
}

const { width, margin } = figureSize;

/** Null where there is no arc to draw along. */
export function arcFigure({ arc, own, support }: Explanation): ArcFigure | null {
  if (!arc || !own) return null;
  const half = own.beam_width / 2;
  const limit = Math.max(half, Math.abs(arc.t_begin), Math.abs(arc.t_end), Math.abs(arc.t), 1e-6);
  // Angles grow to the left of the beam; on the line they grow to the right, as the labels at its ends say.
  const at = (t: number): number => margin + ((width - 2 * margin) * (Math.max(-limit, Math.min(limit, t)) + limit)) / (2 * limit);
  const between = (a: number, b: number): { x0: number; x1: number } => ({ x0: at(Math.min(a, b)), x1: at(Math.max(a, b)) });
  const marks = support.filter((s) => s.t !== null).map((s): FigureMark => ({ ping: s.ping.ping, kind: s.angle === null ? 'cut' : 'crossing', x: at(s.t ?? 0) }));
  return {
    limit, axis: at(0), left: between(arc.t_begin, arc.t_end), whole: between(-limit, limit), point: at(arc.t),
    bound: arc.bound_t === null ? null : between(arc.t - arc.bound_t, arc.t + arc.bound_t), marks,
  };
}

/** A label that is centred on a place, moved so that it stays inside. */
export function labelPlace(x: number, halfWidth: number): number {
  return Math.max(halfWidth, Math.min(width - halfWidth, x));
}
