// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Puts fresh content in place of the old only where it differs, and keeps what has the focus. */
export function refill(host: HTMLElement, fresh: readonly HTMLElement[]): void {
  const key = fresh.map((element) => element.outerHTML).join('');
  if (written.get(host) === key) return;
  written.set(host, key);
  const focused = host.contains(document.activeElement) ? focusables(host).indexOf(document.activeElement as HTMLElement) : -1;
  host.replaceChildren(...fresh);
  if (focused >= 0) focusables(host)[focused]?.focus({ preventScroll: true });
}
const written = new WeakMap<HTMLElement, string>();
const focusables = (host: HTMLElement): HTMLElement[] => [...host.querySelectorAll<HTMLElement>('button, input, select, a[href]')];
