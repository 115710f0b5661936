// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** A choice of two, as a group of radio buttons. */
import { h } from '../ui/dom.ts';

export interface Choice { key: string; label: string; disabled?: boolean; title?: string }

export function switchGroup(label: string, choices: readonly Choice[], chosen: string, choose: (key: string) => void): HTMLElement {
  const move = (event: KeyboardEvent): void => {
    if (!['ArrowLeft', 'ArrowRight', 'ArrowUp', 'ArrowDown'].includes(event.key)) return;
    event.preventDefault();
    event.stopPropagation();
    const usable = choices.filter((c) => !c.disabled);
    const at = usable.findIndex((c) => c.key === chosen);
    const next = usable[(at + (event.key === 'ArrowLeft' || event.key === 'ArrowUp' ? -1 : 1) + usable.length) % usable.length];
    if (!next || next.key === chosen) return;
    group.querySelector<HTMLElement>(`[data-key="${label}-${next.key}"]`)?.focus();
    choose(next.key);
  };
  const group = h('div', { class: 'sel step-switch', role: 'radiogroup', 'aria-label': label }, choices.map((c) => h('button', {
    class: c.key === chosen ? 'on' : null, role: 'radio', 'aria-checked': String(c.key === chosen), tabindex: c.key === chosen ? 0 : -1,
    disabled: c.disabled ?? false, title: c.title ?? null, 'data-key': `${label}-${c.key}`,
  }, c.label, { click: () => choose(c.key) })), { keydown: move });
  return group;
}
