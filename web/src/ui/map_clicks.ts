// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Clicks on the map: explain, go to a point, and the long-press menu. */
import type { MapPlace, Pick } from '../map/map_view.ts';
import { askForToken } from '../drive/rights.ts';
import { liveSlot } from '../explain/live_point.ts';
import { words } from '../words.ts';
import type { App } from './app.ts';
import { h } from './dom.ts';
import { fixed } from './format.ts';
import { mountHoverTag } from './hover_tag.ts';
import { menu } from './popover.ts';
import { openSheet } from './sheet.ts';
import { hideToast, toast } from './toast.ts';

export interface MapClicks { startGoTo(): boolean; cancel(): boolean; walk(direction: 1 | -1): void; explainWalked(): boolean }

export function mountMapClicks(app: App): MapClicks {
  let picking = false;
  let walked: Pick | null = null;
  const tag = mountHoverTag(app);
  const goTo = (x: number, y: number): void => {
    if (picking) hideToast();
    picking = false;
    if (!app.model.welcome?.you.may_drive) { askForToken(app); return; }
    app.model.send({ type: 'mode', mode: 'goto', x, y });
  };
  const explainPick = (pick: Pick | null): boolean => {
    tag(null);
    if (pick?.kind === 'point') {
      const slot = liveSlot(app.model.liveMaps.get(pick.method), pick);
      if (slot === null) { toast(words.goneSince); return true; }
      app.model.show({ name: 'explain', explain: { method: pick.method, slot, x: pick.x, y: pick.y } }, true);
    }
    if (pick?.kind === 'cell') app.model.show({ name: 'explain', explain: { method: pick.method, slot: null, x: pick.x, y: pick.y } }, true);
    else if (pick?.kind === 'arc') app.model.show({ name: 'step', ping: pick.ping.id, step: 1, cell: null }, true);
    if (pick) openSheet(); // also where the same panel was shown and its sheet closed
    return pick !== null;
  };
  const explain = (place: MapPlace): void => {
    if (!explainPick(place.pick)) toast(words.nothingNear);
  };
  app.map.onHover = (place) => { walked = null; tag(place?.touch ? null : place?.pick ?? null); };
  app.map.onClick = (place) => { if (picking) goTo(place.x, place.y); else explain(place); };
  app.map.onLongPress = (place) => {
    const anchor = h('span', { class: 'anchor', tabindex: -1 });
    const box = app.mapHost.getBoundingClientRect();
    anchor.style.setProperty('left', `${box.left + place.px}px`);
    anchor.style.setProperty('top', `${box.top + place.py}px`);
    document.body.append(anchor);
    setTimeout(() => anchor.remove(), 0);
    menu(anchor, 'Here', [
      ...(app.model.welcome?.modes.includes('goto') ? [{ label: 'Go here', run: () => goTo(place.x, place.y) }] : []),
      { label: 'Explain', run: () => explain(place) },
      { label: 'Copy position', run: () => void navigator.clipboard?.writeText(`${fixed(place.x, 3)}, ${fixed(place.y, 3)}`) },
    ]);
  };
  app.model.on('state', () => { const goal = app.model.state?.goal; app.map.setGoal(goal ? { x: goal[0], y: goal[1] } : null); });
  return {
    startGoTo: () => {
      if (!app.model.welcome?.modes.includes('goto')) return false;
      picking = true;
      toast('Click where the robot shall go. Esc cancels.');
      return true;
    },
    walk: (direction) => { walked = app.map.stepPoint(direction); tag(walked); },
    explainWalked: () => explainPick(walked),
    cancel: () => { const was = picking; picking = false; return was; },
  };
}
