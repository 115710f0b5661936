// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** A tile per sensor: what it heard in the last half minute. */
import type { App } from '../ui/app.ts';
import { h } from '../ui/dom.ts';
import { fixed } from '../ui/format.ts';
import { compassTick } from '../ui/marks.ts';
import { offPlan } from '../panels/sensor_panel.ts';
import { canvasOf, colour } from './canvas.ts';

const spanS = 30, heightPx = 40, intervalMs = 500;

/** From rear left over the front to rear right, so that neighbours are neighbours on the robot. */
export function leftToRight<T extends { T_robot_sensor: readonly number[] }>(sensors: readonly T[]): T[] {
  return [...sensors].sort((a, b) => (b.T_robot_sensor[2] ?? 0) - (a.T_robot_sensor[2] ?? 0));
}

interface Tile { id: number; planHz: number | null; button: HTMLButtonElement; status: HTMLElement; canvas: HTMLCanvasElement }

export function mountStrip(app: App, host: HTMLElement): void {
  let tiles: Tile[] = [];
  const build = (): void => {
    const sensors = leftToRight(app.model.welcome?.robot.sensors ?? []);
    host.style.setProperty('--sensors', String(Math.max(1, sensors.length)));
    const limit = Math.ceil(Math.max(1, ...sensors.map((s) => s.range_max_m)));
    tiles = sensors.map((sensor) => {
      const status = h('span', { class: 'x' }), canvas = h('canvas');
      const button = h('button', { class: 'se' }, [h('span', { class: 'hd' }, [compassTick(sensor.T_robot_sensor[2]), h('b', {}, String(sensor.id)), status]), canvas], {
        click: () => app.model.show({ name: 'sensor', sensor: sensor.id }, true),
        pointerenter: () => app.map.setSensor(sensor.id), pointerleave: () => app.map.setSensor(null),
      });
      return { id: sensor.id, planHz: sensor.rate_hz, button, status, canvas };
    });
    host.replaceChildren(h('div', { class: 'ax', 'aria-hidden': 'true' }, [h('span', {}, '30 s'), h('span', {}, `${limit} m`), h('span', {}, '0')]), ...tiles.map((t) => t.button));
    draw();
  };
  const draw = (): void => {
    if (document.hidden || host.offsetHeight === 0) return;
    for (const tile of tiles) { label(app, tile); plot(app, tile); }
  };
  app.model.on('welcome', build);
  app.model.on('view', () => { for (const t of tiles) t.button.classList.toggle('on', app.model.view.name === 'sensor' && app.model.view.sensor === t.id); });
  setInterval(draw, intervalMs);
  build();
}

function label(app: App, tile: Tile): void {
  const counts = app.model.counters?.sensors.find((s) => s.id === tile.id);
  if (!counts) return;
  const slow = offPlan(counts.rate_hz, tile.planHz);
  const rejected = counts.rejected_last_minute;
  tile.status.classList.toggle('slow', slow || !counts.on);
  tile.status.textContent = !counts.on ? 'off' : slow ? `${fixed(counts.rate_hz, 1)}/s` : rejected > 0 ? `×${rejected}` : '';
  tile.button.setAttribute('aria-label', `Sensor ${tile.id}: ${fixed(counts.rate_hz, 1)} pings per second, ${rejected} rejected in the last minute`);
}

function plot(app: App, tile: Tile): void {
  const drawing = canvasOf(tile.canvas, heightPx);
  if (!drawing) return;
  const { context: c, width } = drawing;
  const now = app.model.view.heldAt ?? app.model.state?.t ?? 0;
  const limit = Math.ceil(Math.max(1, app.model.welcome?.robot.sensors.find((s) => s.id === tile.id)?.range_max_m ?? 4));
  const hit = colour('--hit'), none = colour('--none'), rej = colour('--rej');
  c.fillStyle = colour('--line');
  c.fillRect(0, heightPx - 1, width, 1);
  for (const p of app.model.pings.ofSensor(tile.id, now - spanS)) {
    if (p.t > now) continue;
    const x = width - 2 - ((now - p.t) / spanS) * (width - 4);
    const y = heightPx - 2 - (Math.min(limit, p.rangeM || 0) / limit) * (heightPx - 6);
    if (p.outcome === 'echo') { c.fillStyle = hit; c.fillRect(x - 1, y - 1, 2.2, 2.2); }
    else if (p.outcome === 'no_echo') { c.strokeStyle = none; c.lineWidth = 1; c.strokeRect(x - 0.8, 2.5, 1.6, 2); }
    else { c.strokeStyle = rej; c.lineWidth = 1.5; c.beginPath(); c.moveTo(x - 3, y - 3); c.lineTo(x + 3, y + 3); c.moveTo(x + 3, y - 3); c.lineTo(x - 3, y + 3); c.stroke(); }
  }
}
