// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Icons of 16 px, strokes of 1.5. */
import { h, svg } from './dom.ts';

const paths = {
  chev: 'M4 6l4 4 4-4',
  open: 'M2 12.5V4.2c0-.7.5-1.2 1.2-1.2h3l1.6 1.8h5c.7 0 1.2.5 1.2 1.2v6.5c0 .6-.4 1-1 1H3c-.6 0-1-.4-1-1z',
  link: 'M6.8 9.2a2.6 2.6 0 0 0 3.8 0l2-2a2.7 2.7 0 0 0-3.8-3.8l-.9.9M9.2 6.8a2.6 2.6 0 0 0-3.8 0l-2 2a2.7 2.7 0 0 0 3.8 3.8l.9-.9',
  moon: 'M13 9.6A5.6 5.6 0 0 1 6.4 3a5.6 5.6 0 1 0 6.6 6.6z',
  sun: 'M8 5.2a2.8 2.8 0 1 0 0 5.6 2.8 2.8 0 0 0 0-5.6zM8 1.2v1.4M8 13.4v1.4M1.2 8h1.4M13.4 8h1.4M3.2 3.2l1 1M11.8 11.8l1 1M12.8 3.2l-1 1M4.2 11.8l-1 1',
  help: 'M8 14.2A6.2 6.2 0 1 0 8 1.8a6.2 6.2 0 0 0 0 12.4zM6.2 6.3a1.9 1.9 0 1 1 2.7 1.8c-.6.3-.9.6-.9 1.3M8 11.4v.2',
  save: 'M8 2v7.5M4.8 6.6L8 9.8l3.2-3.2M2.5 12.8h11',
  drive: 'M8 14A6 6 0 1 0 8 2a6 6 0 0 0 0 12zM8 9.6a1.6 1.6 0 1 0 0-3.2 1.6 1.6 0 0 0 0 3.2zM2.2 7l4.2.6M13.8 7l-4.2.6M8 9.6V14',
  plus: 'M8 3.2v9.6M3.2 8h9.6',
  minus: 'M3.2 8h9.6',
  fit: 'M2.5 6V2.5H6M10 2.5h3.5V6M13.5 10v3.5H10M6 13.5H2.5V10',
  follow: 'M8 12.4a4.4 4.4 0 1 0 0-8.8 4.4 4.4 0 0 0 0 8.8zM8 1.2v3M8 11.8v3M1.2 8h3M11.8 8h3',
  eye: 'M1.6 8S4 3.6 8 3.6 14.4 8 14.4 8 12 12.4 8 12.4 1.6 8 1.6 8zM8 9.9a1.9 1.9 0 1 0 0-3.8 1.9 1.9 0 0 0 0 3.8z',
  eyeoff: 'M2 2l12 12M6.4 3.8A6 6 0 0 1 8 3.6c4 0 6.4 4.4 6.4 4.4a11 11 0 0 1-1.9 2.4M4 5a10.600 10.600 0 0 0-2.400 3S4 12.400 8 12.400a6 6 0 0 0 2.800-.7',
  gear: 'M2 5h6M12 5h2M2 11h2M8 11h6M10 3.200a1.800 1.800 0 1 0 0 3.600 1.800 1.800 0 0 0 0-3.600zM6 9.200a1.800 1.800 0 1 0 0 3.600 1.800 1.800 0 0 0 0-3.600z',
  back: 'M10 3.500L5.500 8l4.500 4.500',
  play: 'M5 3.200v9.600l7.600-4.800z',
  pause: 'M5.500 3.500v9M10.500 3.500v9',
  prev: 'M11 4L6.500 8l4.500 4M4.500 4v8',
  next: 'M5 4l4.500 4L5 12M11.500 4v8',
  layers: 'M8 2.200L14 5.500 8 8.800 2 5.500zM2.300 8.400L8 11.500l5.700-3.100M2.300 11L8 14.100l5.700-3.100',
  warn: 'M8 2.2L14.4 13.4H1.6zM8 6.4v3.2M8 11.4v.2',
  chart: 'M2.5 13.5h11M4 11V8M7 11V4M10 11V6.5M13 11V2.5',
  cross: 'M4 4l8 8M12 4l-8 8',
  pad: 'M8 14A6 6 0 1 0 8 2a6 6 0 0 0 0 12zM8 4v2M8 10v2M4 8h2M10 8h2',
  frontier: 'M2 13.500c2-.2 2.600-1.800 2.600-3.500S5.800 6.400 8 6.400M8 6.400l5.500-3.900M13.500 2.500v3.600M13.500 2.500H9.900M9.500 13.500h.1M12.500 13.500h.1M12.500 10.500h.1',
  graph: 'M3.500 14a1.500 1.500 0 1 0 0-3 1.500 1.500 0 0 0 0 3zM8 8.500a1.500 1.500 0 1 0 0-3 1.500 1.500 0 0 0 0 3zM12.500 14a1.500 1.500 0 1 0 0-3 1.500 1.500 0 0 0 0 3zM8 5.500v-4M7 8.200l-2.600 3.100M9 8.200l2.600 3.100',
  wallLeft: 'M2.500 2v12M2.500 4l-1 1M2.500 8l-1 1M2.500 12l-1 1M8.500 13.500v-10M5.700 6.200l2.800-2.800 2.800 2.800',
  wallRight: 'M13.500 2v12M13.500 4l1 1M13.500 8l1 1M13.500 12l1 1M7.500 13.500v-10M4.700 6.200l2.800-2.800 2.800 2.800',
  point: 'M8 14.500S12.500 10 12.500 6.400a4.500 4.500 0 1 0-9 0C3.500 10 8 14.500 8 14.500zM8 8.100a1.700 1.700 0 1 0 0-3.400 1.700 1.700 0 0 0 0 3.400z',
  home: 'M2 8l6-5.500L14 8M3.800 6.600v6.900h8.400V6.600M6.600 13.500v-4h2.800v4',
  tour: 'M13 8a5 5 0 1 1-1.600-3.700M13.200 1.800v3h-3',
  stand: 'M5.500 3.500v9M10.500 3.500v9',
};

export type IconName = keyof typeof paths;

export function icon(name: IconName): HTMLElement {
  const drawing = svg('svg', {
    viewBox: '0 0 16 16', width: 16, height: 16, fill: name === 'play' ? 'currentColor' : 'none', stroke: 'currentColor',
    'stroke-width': 1.5, 'stroke-linecap': 'round', 'stroke-linejoin': 'round', 'aria-hidden': 'true',
  }, [svg('path', { d: paths[name] })]);
  return h('i', { class: 'ic' }, [drawing]);
}

export function stopIcon(): HTMLElement {
  return h('i', { class: 'ic' }, [svg('svg', { viewBox: '0 0 20 20', width: 20, height: 20, 'aria-hidden': 'true' }, [
    svg('path', {
      d: 'M6.3 1.5h7.4l4.8 4.8v7.4l-4.8 4.8H6.3l-4.8-4.8V6.3z', fill: 'none', stroke: 'currentColor', 'stroke-width': 1.8,
    }),
    svg('rect', { x: 6.6, y: 6.6, width: 6.8, height: 6.8, rx: 1, fill: 'currentColor' }),
  ])]);
}

export function logo(): SVGElement {
  const arc = (d: string, opacity: number): SVGElement =>
    svg('path', { d, opacity, fill: 'none', stroke: 'currentColor', 'stroke-width': 2, 'stroke-linecap': 'round' });
  return svg('svg', { viewBox: '0 0 24 24', width: 22, height: 22, 'aria-hidden': 'true' }, [
    svg('circle', { cx: 5, cy: 19, r: 2.6, fill: 'currentColor' }), arc('M11.2 19A6.2 6.2 0 0 0 5 12.8', 1),
    arc('M16 19A11 11 0 0 0 5 8', 0.6), arc('M20.8 19A15.8 15.8 0 0 0 5 3.2', 0.3),
  ]);
}
