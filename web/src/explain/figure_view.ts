// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

import { degrees, signedDegrees } from '../formula/numbers.ts';
import type { MarkSlot } from '../map/slots.ts';
import type { Explanation } from '../protocol/messages.ts';
import { svg } from '../ui/dom.ts';
import { arcFigure, figureSize, labelPlace } from './figure.ts';
import { markWord, words } from './words.ts';

const { width, height, margin, line } = figureSize;
const labelHalfWidth = 52;

function pointMark(slot: MarkSlot, x: number): SVGElement {
  const at = `translate(${x.toFixed(2)} ${line})`;
  if (slot === 1) return svg('path', { class: 'arc-point', transform: at, d: 'M0-9L9 0 0 9-9 0z' });
  if (slot === 2) return svg('circle', { class: 'arc-point', transform: at, r: 7 });
  if (slot === 3) return svg('path', { class: 'arc-point-line', transform: at, d: 'M-6-6L6 6M6-6L-6 6' });
  return svg('path', { class: 'arc-point', transform: at, d: 'M-6-6h12v12h-12z' });
}

/** Null where the method has no arc for it. Marks carry `data-ping`, so that the table can light them up. */
/** `name`: of the method in the catalogue. */
export function figureView(explanation: Explanation, slot: MarkSlot, name: string): SVGElement | null {
  const figure = arcFigure(explanation);
  if (!figure || !explanation.arc) return null;
  const { whole, left, bound, point } = figure;
  const label = `${markWord(name)} ${signedDegrees(explanation.arc.t)}`;
  const parts: SVGElement[] = [
    svg('path', { class: 'arc-whole', d: `M${whole.x0} ${line}H${whole.x1}` }),
    svg('path', { class: 'arc-left', d: `M${left.x0} ${line}H${left.x1}` }),
    svg('path', { class: 'arc-axis', d: `M${figure.axis} ${line + 12}v6` }),
  ];
  if (bound) {
    parts.push(svg('rect', { class: 'arc-bound', x: bound.x0, y: line - 8, width: Math.max(0.5, bound.x1 - bound.x0), height: 16 }),
      svg('path', { class: 'arc-bracket', d: `M${bound.x0} ${line - 11}v22M${bound.x1} ${line - 11}v22` }));
  }
  for (const mark of figure.marks) {
    parts.push(mark.kind === 'crossing'
      ? svg('circle', { class: 'arc-crossing', 'data-ping': mark.ping, cx: mark.x, cy: line, r: 4.5 })
      : svg('path', { class: 'arc-cut', 'data-ping': mark.ping, d: `M${mark.x} ${line - 8}v16` }));
  }
  const text = (x: number, y: number, anchor: string, content: string, kind = ''): SVGElement => svg('text', { class: kind === '' ? null : kind, x, y, 'text-anchor': anchor }, [content]);
  parts.push(pointMark(slot, point), text(labelPlace(point, labelHalfWidth), 20, 'middle', label, 'arc-label'),
    text(margin, 76, 'start', `−${degrees(figure.limit)}`), text(figure.axis, 76, 'middle', words.axis), text(width - margin, 76, 'end', `+${degrees(figure.limit)}`));
  return svg('svg', { class: `chart arc-figure slot-${slot}`, viewBox: `0 0 ${width} ${height}`, role: 'img', 'aria-label': `${figure.marks.length} marks along the arc; ${label}` }, parts);
}
