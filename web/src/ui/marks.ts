// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Small pictures of what lies on the map, as it is drawn there. */
import { svg } from './dom.ts';

function picture(width: number, children: SVGElement[]): SVGElement {
  return svg('svg', { class: 'sw', viewBox: `0 0 ${width} 16`, width, height: 16, 'aria-hidden': 'true' }, children);
}
const path = (d: string, more: Record<string, string | number>): SVGElement => svg('path', { d, fill: 'none', ...more });

/** Slot 0 is a grid; 1 diamond, 2 disc, 3 cross, 4 open square. */
export function methodMark(slot: number): SVGElement {
  switch (slot) {
    case 0: return picture(16, [path('M2 2h6v6H2zM8 8h6v6H8z', { fill: 'var(--occ)' }), path('M2.5 2.5h11v11h-11z', { stroke: 'var(--occ)' })]);
    case 1: return picture(16, [path('M8 2l6 6-6 6-6-6z', { fill: 'var(--atm)' })]);
    case 2: return picture(16, [svg('circle', { cx: 8, cy: 8, r: 5, fill: 'var(--carve)' })]);
    case 3: return picture(16, [path('M3.5 3.5l9 9M12.5 3.5l-9 9', { stroke: 'var(--center)', 'stroke-width': 2.6, 'stroke-linecap': 'round' })]);
    default: return picture(16, [path('M3.5 3.5h9v9h-9z', { stroke: 'var(--ink3)', 'stroke-width': 2 })]);
  }
}

export function layerPicture(name: string): SVGElement {
  switch (name) {
    case 'arcs': return picture(20, [path('M1 14L14 2a14 14 0 0 1 4 10z', { fill: 'var(--hit)', opacity: 0.25 }),
      path('M14 2a14 14 0 0 1 4 10', { stroke: 'var(--hit)', 'stroke-width': 2, 'stroke-linecap': 'round' })]);
    case 'bounds': return picture(20, [path('M4 13A14 14 0 0 1 16 3', { stroke: 'var(--atm)', 'stroke-width': 3, opacity: 0.4 }),
      path('M9 4.2l3 3-3 3-3-3z', { fill: 'var(--atm)' })]);
    case 'path': return picture(20, [path('M2 13c4 0 3-9 8-9s4 6 8 5', { stroke: 'var(--accent)', 'stroke-width': 1.5 })]);
    case 'plan': return picture(20, [path('M2 12L8 5l5 5', { stroke: 'var(--ink2)', 'stroke-width': 1.75 }), path('M13 10l5-7', { stroke: 'var(--accent)', 'stroke-width': 2, 'stroke-dasharray': '3 2' }),
      svg('circle', { cx: 8, cy: 5, r: 2.2, fill: 'var(--ink)' })]);
    case 'truth': return picture(20, [path('M2 12V4h16', { stroke: 'var(--ink3)', 'stroke-width': 1.5, 'stroke-dasharray': '1.5 2.5' })]);
    default: return picture(20, [[3, 11], [7, 7], [12, 5], [17, 5]].map(([cx, cy]) => svg('circle', { cx: cx ?? 0, cy: cy ?? 0, r: 1.2, fill: 'var(--ink3)' })));
  }
}

export function outcomeMark(outcome: 'echo' | 'no_echo' | 'rejected'): SVGElement {
  if (outcome === 'echo') return picture(16, [path('M2 14L9 2a12 12 0 0 1 5 7z', { fill: 'var(--hit)', opacity: 0.25 }),
    path('M9 2a12 12 0 0 1 5 7', { stroke: 'var(--hit)', 'stroke-width': 2.2, 'stroke-linecap': 'round' })]);
  if (outcome === 'no_echo') return picture(16, [path('M2 14L9 2a12 12 0 0 1 5 7z', { stroke: 'var(--none)', 'stroke-width': 1.2, 'stroke-linejoin': 'round' })]);
  return picture(16, [path('M2 14L9 2a12 12 0 0 1 5 7z', { stroke: 'var(--rej)', 'stroke-width': 1.5, 'stroke-dasharray': '3 2' }),
    path('M9.5 4l4 4M13.5 4l-4 4', { stroke: 'var(--rej)', 'stroke-width': 1.7 })]);
}

/** Which way a sensor looks from the robot; up is ahead. */
export function compassTick(yawRad: number): SVGElement {
  return svg('svg', { viewBox: '0 0 12 12', width: 12, height: 12, 'aria-hidden': 'true' }, [
    svg('circle', { cx: 6, cy: 6, r: 4, fill: 'none', stroke: 'var(--line2)', 'stroke-width': 1.5 }),
    path(`M6 6L${(6 - 5.5 * Math.sin(yawRad)).toFixed(2)} ${(6 - 5.5 * Math.cos(yawRad)).toFixed(2)}`, { stroke: 'var(--ink)', 'stroke-width': 1.8, 'stroke-linecap': 'round' }),
  ]);
}
