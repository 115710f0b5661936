// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

import type { Counters } from '../protocol/messages.ts';
import type { App, Panel } from '../ui/app.ts';
import { h, svg } from '../ui/dom.ts';
import { fixed, share, whole, words as plain } from '../ui/format.ts';
import { saveBlob } from '../ui/save.ts';
import { backButton } from './back.ts';
import { sum } from './readings.ts';
import { refill } from './refill.ts';

type SensorCounts = Counters['sensors'][number];
const width = 312, height = 150, spanS = 60;

/** More than 20 % off the plan. */
export function offPlan(rateHz: number, planHz: number | null): boolean { return planHz !== null && planHz > 0 && Math.abs(rateHz - planHz) > 0.2 * planHz; }

export function sensorSentence(yawRad: number, rateHz: number, planHz: number | null, on: boolean): string {
  const degrees = (yawRad * 180) / Math.PI;
  const side = Math.abs(degrees) < 0.5 ? 'ahead' : Math.abs(degrees) > 179.5 ? 'back' : `${fixed(Math.abs(degrees), 1)}° ${degrees > 0 ? 'left' : 'right'}`;
  if (!on) return `Points ${side}. It is turned off for the maps.`;
  const plan = planHz === null ? '' : offPlan(rateHz, planHz) ? `, ${fixed(planHz, 1)} were planned` : ', as planned';
  return `Points ${side}. ${fixed(rateHz, 1)} pings per second${plan}.`;
}

function rangePlot(app: App, sensor: number): SVGElement {
  const now = app.model.view.heldAt ?? app.model.state?.t ?? 0;
  const limit = Math.max(1, Math.ceil(app.model.welcome?.robot.sensors.find((s) => s.id === sensor)?.range_max_m ?? 4));
  const x = (t: number): number => 30 + (width - 34) * (1 - (now - t) / spanS);
  const y = (r: number): number => height - 20 - ((height - 34) * Math.min(limit, r)) / limit;
  const parts: SVGElement[] = [];
  for (let i = 0; i <= 4; i++) {
    const r = (limit * i) / 4;
    parts.push(svg('path', { d: `M30 ${y(r) + 0.5}H${width}`, stroke: 'var(--line)' }), svg('text', { x: 22, y: y(r) + 4, 'text-anchor': 'end', fill: 'var(--ink3)' }, [String(Number(r.toFixed(1)))]));
  }
  for (const p of app.model.pings.ofSensor(sensor, now - spanS)) {
    if (p.t > now) continue;
    if (p.outcome === 'echo') parts.push(svg('circle', { cx: x(p.t), cy: y(p.rangeM), r: 2.2, fill: 'var(--hit)' }));
    else if (p.outcome === 'no_echo') parts.push(svg('rect', { x: x(p.t) - 1.2, y: 3, width: 2.4, height: 5, fill: 'none', stroke: 'var(--none)' }));
    else parts.push(svg('path', { d: `M${x(p.t) - 3.5} ${y(p.rangeM || 0) - 3.5}l7 7m0 -7l-7 7`, stroke: 'var(--rej)', 'stroke-width': 2 }));
  }
  parts.push(svg('text', { x: 30, y: height - 3, fill: 'var(--ink3)' }, ['1 min ago']), svg('text', { x: width, y: height - 3, 'text-anchor': 'end', fill: 'var(--ink3)' }, ['now']));
  return svg('svg', { class: 'chart', viewBox: `0 0 ${width} ${height}`, role: 'img', 'aria-label': `Range of sensor ${sensor} over the last minute` }, parts);
}

function table(app: App, chosen: number): HTMLElement {
  const row = (s: SensorCounts): HTMLElement => {
    const rejected = sum(s.rejected) + s.too_close, n = s.echoes + s.no_echoes + rejected;
    const plan = app.model.welcome?.robot.sensors.find((r) => r.id === s.id)?.rate_hz ?? null;
    return h('tr', { class: s.id === chosen ? 'hov' : '' }, [
      h('td', {}, [h('button', { class: 'link', 'aria-label': `Sensor ${s.id}` }, [h('b', {}, String(s.id))], { click: () => app.model.show({ sensor: s.id }) })]),
      h('td', { class: offPlan(s.rate_hz, plan) ? 'warned' : '' }, s.on ? fixed(s.rate_hz, 1) : 'off'), h('td', {}, share(s.echoes, n)), h('td', {}, share(s.no_echoes, n)), h('td', {}, rejected ? whole(rejected) : '–')]);
  };
  const head = ['Sensor', 'Per s', 'Echo', 'No echo', 'Rejected'].map((name) => h('th', { scope: 'col' }, name));
  return h('table', { class: 'dense' }, [h('thead', {}, [h('tr', {}, head)]), h('tbody', {}, (app.model.counters?.sensors ?? []).map(row))]);
}

function exportCsv(app: App, sensor: number): void {
  const lines = app.model.pings.ofSensor(sensor, Number.NEGATIVE_INFINITY).map((p) => [p.id, p.t, Number.isNaN(p.rangeM) ? '' : p.rangeM, p.outcome].join(','));
  saveBlob(new Blob([['ping,t_s,range_m,outcome', ...lines].join('\n'), '\n'], { type: 'text/csv' }), `sensor-${sensor}.csv`);
}

export function makeSensorPanel(app: App): Panel {
  const title = h('h1', { tabindex: -1 }), sentence = h('p'), plot = h('div'), why = h('p', { class: 'small' }), all = h('div'), toggle = h('button', { class: 'btn grow' });
  const chosen = (): number => app.model.view.sensor ?? app.model.welcome?.robot.sensors[0]?.id ?? 0;
  const update = (): void => {
    const id = chosen();
    const known = app.model.welcome?.robot.sensors.find((s) => s.id === id);
    const counts = app.model.counters?.sensors.find((s) => s.id === id);
    title.textContent = `Sensor ${id}`;
    sentence.textContent = sensorSentence(known?.T_robot_sensor[2] ?? 0, counts?.rate_hz ?? 0, known?.rate_hz ?? null, counts?.on ?? true);
    refill(plot, [rangePlot(app, id) as unknown as HTMLElement]);
    const rejected = Object.entries(counts?.rejected ?? {}).filter(([, n]) => n > 0).map(([name, n]) => `${whole(n)} as ${plain(name)}`);
    why.textContent = rejected.length ? `Rejected: ${rejected.join(', ')}.` : 'None rejected.';
    refill(all, [table(app, id)]);
    toggle.textContent = `Turn sensor ${id} ${counts?.on === false ? 'on' : 'off'}`;
    toggle.disabled = !app.model.welcome?.you.may_drive;
  };
  toggle.addEventListener('click', () => { const id = chosen(); app.model.send({ type: 'sensor', sensor: id, on: app.model.counters?.sensors.find((s) => s.id === id)?.on === false }); });
  return {
    title: 'Sensor', update, unmount: () => undefined,
    mount(host) {
      host.append(h('section', { class: 'sec' }, [backButton(app), title, sentence]), h('section', { class: 'sec' }, [h('h2', {}, ['Range, m', h('span', { class: 'r' }, 'last minute')]), plot, why]),
        h('section', { class: 'sec grow' }, [h('h2', {}, 'All sensors'), all]), h('div', { class: 'foot' }, [toggle, h('button', { class: 'btn quiet' }, 'Export CSV', { click: () => exportCsv(app, chosen()) })]));
      update();
    },
  };
}
