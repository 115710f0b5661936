// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Menus and popovers that hang below their button; dialogs, which repeat Stop. */
import { h, type Child } from './dom.ts';
import { icon, type IconName } from './icons.ts';

export interface MenuItem { label: string; icon?: IconName; note?: string; current?: boolean; disabled?: boolean; run: () => void }
const marginPx = 8;
let open: { box: HTMLElement; opener: HTMLElement } | null = null;

export function closePopover(focusOpener = true): boolean {
  if (!open) return false;
  open.box.remove();
  open.opener.setAttribute('aria-expanded', 'false');
  if (focusOpener) open.opener.focus();
  open = null;
  return true;
}

export function popover(opener: HTMLElement, label: string, children: readonly Child[], role = 'dialog'): HTMLElement | null {
  const same = open?.opener === opener;
  closePopover(false);
  if (same) return null;
  const box = h('div', { class: 'pop', role, 'aria-label': label, tabindex: -1 }, children);
  document.body.append(box);
  const at = opener.getBoundingClientRect();
  const width = box.offsetWidth;
  box.style.setProperty('left', `${Math.max(8, Math.min(at.left, innerWidth - width - 8))}px`);
  const below = at.bottom + 6 + box.offsetHeight < innerHeight;
  box.style.setProperty('top', `${below ? at.bottom + 6 : Math.max(8, at.top - box.offsetHeight - 6)}px`);
  keepOffStop(box);
  opener.setAttribute('aria-expanded', 'true');
  open = { box, opener };
  (box.querySelector<HTMLElement>('[role^=menuitem],[role=option],button,input') ?? box).focus();
  return box;
}

/** Beside Stop or, where there is no room, ending above it. */
function keepOffStop(box: HTMLElement): void {
  const stop = document.getElementById('stop')?.getBoundingClientRect();
  const own = box.getBoundingClientRect();
  if (!stop || stop.width === 0 || own.right < stop.left - marginPx || own.left > stop.right || own.bottom < stop.top - marginPx || own.top > stop.bottom) return;
  const left = stop.left - marginPx - own.width;
  if (left >= marginPx) { box.style.setProperty('left', `${left}px`); return; }
  const bottom = stop.top - marginPx;
  const height = Math.min(own.height, bottom - marginPx);
  box.style.setProperty('max-height', `${height}px`);
  box.style.setProperty('top', `${Math.min(own.top, bottom - height)}px`);
}

export function menu(opener: HTMLElement, label: string, items: readonly MenuItem[], role: 'menu' | 'listbox' = 'menu'): void {
  const itemRole = role === 'menu' ? 'menuitem' : 'option';
  const rows = items.map((item) => h('button', {
    class: `item${(item.note?.length ?? 0) > 12 ? ' two' : ''}`, role: itemRole, disabled: item.disabled ?? false, 'aria-selected': role === 'listbox' ? String(item.current ?? false) : null, 'aria-current': role === 'menu' && item.current === true ? 'true' : null,
  }, [item.icon !== undefined && icon(item.icon), h('span', {}, item.label), item.note !== undefined && h('small', {}, item.note)], { click: () => { closePopover(); item.run(); } }));
  const box = popover(opener, label, rows, role);
  box?.addEventListener('keydown', (event) => {
    const step = event.key === 'ArrowDown' ? 1 : event.key === 'ArrowUp' ? -1 : 0;
    if (step === 0) return;
    event.preventDefault();
    event.stopPropagation();
    const usable = rows.filter((row) => !row.disabled);
    const at = usable.findIndex((row) => row === document.activeElement);
    usable[(at + step + usable.length) % usable.length]?.focus();
  });
}

addEventListener('pointerdown', (event) => {
  const target = event.target as Node;
  if (open && !open.box.contains(target) && !open.opener.contains(target)) closePopover(false);
});
addEventListener('keydown', (event) => {
  if (event.key === 'Escape' && closePopover()) event.stopImmediatePropagation();
}, true);

/** A dialog; its header repeats Stop, which is under the backdrop. */
export function dialog(title: string, children: readonly Child[], stop: () => void): HTMLDialogElement {
  const box = h('dialog', { class: 'dialog', 'aria-label': title });
  const close = h('button', { class: 'btn sm' }, 'Close', { click: () => box.close() });
  const halt = h('button', { class: 'btn sm dialog-stop', 'aria-label': 'Stop robot' }, 'Stop', { pointerdown: stop, click: stop });
  box.append(h('div', { class: 'dialog-head' }, [h('h1', {}, title), halt, close]), ...children.filter((c): c is Node | string => typeof c === 'string' || c instanceof Node));
  box.addEventListener('close', () => box.remove());
  document.body.append(box);
  box.showModal();
  return box;
}
