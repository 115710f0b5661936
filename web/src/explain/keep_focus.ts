// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** New content in place of the old; what has the focus is found again by its `data-key`. */
export function replaceKeepingFocus(host: HTMLElement, children: readonly Node[]): void {
  const active = document.activeElement;
  const key = active instanceof HTMLElement && host.contains(active) ? active.dataset['key'] : undefined;
  host.replaceChildren(...children);
  if (key === undefined) return;
  for (const element of host.querySelectorAll<HTMLElement>('[data-key]')) if (element.dataset['key'] === key) element.focus({ preventScroll: true });
}
