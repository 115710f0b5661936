// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** The inspector as a sheet: on phones held upright from below with three stops, elsewhere on narrow pages from the right. */
const upright = matchMedia('(max-width: 720px) and (orientation: portrait)');
const sideways = matchMedia('(max-width: 1023px) and (min-width: 721px), (max-height: 520px) and (orientation: landscape)');
const attribute = 'data-sheet';
const [lowPx, middlePx, highShare] = [92, 268, 0.8];
const tapPx = 6;

let heightPx = middlePx;
let host: HTMLElement | null = null;
const listeners = new Set<() => void>();

const stops = (): number[] => [lowPx, middlePx, innerHeight * highShare];

function setHeight(px: number): void {
  heightPx = Math.max(lowPx, px);
  host?.style.setProperty('--sheet', `${Math.round(heightPx)}px`);
}

/** A sheet from the right lies over this many pixels of the map. */
export const coveredPx = (): number => (sideways.matches && sheetIsOpen() ? host?.offsetWidth ?? 0 : 0);

export const sheetIsOpen = (): boolean => document.body.hasAttribute(attribute);

/** Shows the sheet, if the inspector is one: what was asked for is to be read, not looked for. */
export function openSheet(): void {
  document.body.toggleAttribute(attribute, true);
  if (upright.matches && heightPx < middlePx) setHeight(middlePx);
  tell();
}

export function closeSheet(): void {
  document.body.removeAttribute(attribute);
  tell();
}

export const toggleSheet = (): void => (sheetIsOpen() ? closeSheet() : openSheet());

/** Hears whenever the sheet opens or closes. */
export function onSheet(listener: () => void): void { listeners.add(listener); }

function tell(): void { for (const listener of listeners) listener(); }

/** The handle steps through the stops, or is dragged to the nearest. */
export function wireHandle(sheet: HTMLElement, handle: HTMLElement): void {
  host = sheet;
  let from: { y: number; height: number } | null = null;
  handle.addEventListener('pointerdown', (event) => { handle.setPointerCapture(event.pointerId); from = { y: event.clientY, height: sheet.offsetHeight }; });
  handle.addEventListener('pointermove', (event) => { if (from) setHeight(from.height + from.y - event.clientY); });
  handle.addEventListener('pointerup', (event) => {
    if (!from) return;
    const moved = Math.abs(event.clientY - from.y) > tapPx;
    const all = stops();
    const at = nearest(all, moved ? from.height + from.y - event.clientY : heightPx);
    from = null;
    setHeight(all[moved ? at : (at + 1) % all.length] ?? middlePx);
  });
}

export function nearest(all: readonly number[], value: number): number {
  return all.reduce((best, stop, i) => (Math.abs(stop - value) < Math.abs((all[best] ?? 0) - value) ? i : best), 0);
}
