// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** One message at a time, at the bottom of the map. */
import { h } from './dom.ts';

export interface ToastAction { label: string; primary?: boolean; run: () => void }
const shownMs = 5000;
let current: HTMLElement | null = null;
let timer: ReturnType<typeof setTimeout> | undefined;

export function hideToast(): void {
  current?.remove();
  current = null;
  clearTimeout(timer);
}

export function toast(text: string, actions: readonly ToastAction[] = [], isError = false, forMs = actions.length === 0 ? shownMs : 0): void {
  hideToast();
  const buttons = actions.map(({ label, primary, run }) =>
    h('button', { class: `btn sm${primary ? ' pri' : ''}` }, label, { click: () => { hideToast(); run(); } }));
  current = h('div', { class: 'toast', role: isError ? 'alert' : 'status' }, [h('span', {}, text), ...buttons]);
  document.getElementById('mapwrap')?.append(current);
  if (forMs > 0) timer = setTimeout(hideToast, forMs);
}
