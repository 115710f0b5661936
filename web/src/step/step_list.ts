// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** The five steps: done ones keep their line, one is open, the others wait. */
import type { Stepped } from '../protocol/messages.ts';
import { h } from '../ui/dom.ts';
import { bodyOf, type BodyContext } from './bodies.ts';
import { lastPart, partLines, type PartLine } from './parts.ts';
import { words } from './words.ts';

function closed(line: PartLine): HTMLElement | null {
  if (line.line === '' && line.strong === '') return null;
  return h('p', { class: 'step-line' }, [line.line, line.strong !== '' && h('b', {}, line.strong)]);
}

export function stepList(s: Stepped, open: number, context: BodyContext, go: (part: number) => void): HTMLElement {
  const last = lastPart(s);
  const items = partLines(s).map((line, index) => {
    const part = index + 1;
    const state = part === open ? 'now' : part < open ? 'done' : 'todo';
    const value = h('span', { class: 'step-value' }, state === 'todo' && line.value !== words.notUsed ? '' : line.value);
    const head = h('button', { class: 'step-head', disabled: part > last, 'data-key': `part-${part}`, 'aria-expanded': String(state === 'now') }, [line.title, value], { click: () => go(part) });
    const body = state === 'now' ? h('div', { class: 'step-body' }, bodyOf(s, line, context)) : state === 'done' ? closed(line) : null;
    return h('li', { class: `step ${state}`, 'aria-current': state === 'now' ? 'step' : null }, [h('span', { class: 'step-number', 'aria-hidden': 'true' }, String(part)), head, body]);
  });
  return h('ol', { class: 'steps' }, items);
}
