// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** One line about what lies under the pointer, or what the keyboard walked to. */
import type { Pick } from '../map/map_view.ts';
import type { App } from './app.ts';
import { h } from './dom.ts';
import { centimetres, fixed, whole, words } from './format.ts';

const gapPx = 10;

export function pickText(app: App, pick: Pick): string {
  if (pick.kind === 'point') {
    const bound = Number.isFinite(pick.boundM) ? ` ±${centimetres(pick.boundM)}` : '';
    return `${app.shortOf(pick.method)}${bound}, ping ${whole(pick.ping)}`;
  }
  if (pick.kind === 'cell') return `${app.shortOf(pick.method)}: ${Number.isFinite(pick.probability) ? `occupied p = ${fixed(pick.probability, 2)}` : 'unknown'}`;
  const { ping } = pick;
  const said = ping.outcome === 'echo' ? `${fixed(ping.rangeM, 2)} m` : ping.outcome === 'rejected' ? words(app.model.welcome?.rejections[ping.reason]?.name ?? 'rejected') : words(ping.outcome);
  return `Ping ${whole(ping.id)}, sensor ${ping.rx}: ${said}`;
}

export function mountHoverTag(app: App): (pick: Pick | null) => void {
  const tag = h('div', { class: 'map-tag above', role: 'status', hidden: true });
  app.mapHost.append(tag);
  let shown: Pick | null = null;
  const place = (): void => {
    if (!shown) return;
    const { px, py } = app.map.toPixels(shown.x, shown.y);
    const x = Math.max(4, Math.min(app.mapHost.clientWidth - tag.offsetWidth - 4, px - tag.offsetWidth / 2));
    const y = Math.max(4, py - tag.offsetHeight - gapPx);
    tag.style.setProperty('transform', `translate(${Math.round(x)}px, ${Math.round(y)}px)`);
    tag.style.setProperty('--tip', `${Math.round(px - x)}px`);
  };
  const hide = (): void => { shown = null; tag.hidden = true; };
  app.mapHost.addEventListener('pointerdown', hide);
  app.mapHost.addEventListener('wheel', hide, { passive: true });
  return (pick) => {
    // Panes of Compare have a camera origin each; their tags would lie in the first.
    if (!pick || app.model.view.name === 'compare') { hide(); return; }
    shown = pick;
    tag.textContent = pickText(app, pick);
    tag.classList.toggle('rejected', pick.kind === 'arc' && pick.ping.outcome === 'rejected');
    tag.hidden = false;
    place();
  };
}
