// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** What the five steps of a ping say when they are closed. */
import type { Stepped } from '../protocol/messages.ts';
import { metres } from '../formula/numbers.ts';
import { gain } from './cells.ts';
import { words } from './words.ts';

export type PartName = 'echo' | 'sensor' | 'arc' | 'cone' | 'cells' | 'arcs' | 'adds' | 'after';
export interface PartLine { name: PartName; title: string; /** At the right of the title. */ value: string; /** Below it once it is done. */ line: string; /** Its end is set in bold. */ strong: string }

export const partCount = 5;

/** A rejected ping ends with its reason. */
export const lastPart = (s: Stepped): number => (s.ping.outcome === 'rejected' ? 1 : partCount);

function echo(s: Stepped): PartLine {
  const { ping, time_of_flight_s: time } = s;
  const value = ping.outcome === 'rejected' ? words.rejected : ping.outcome === 'too_close' ? words.tooClose : time === null ? words.silence : words.milliseconds(time);
  const isTimed = time !== null && ping.range_m !== null;
  const line = isTimed ? words.halfPath(s.speed_of_sound_m_s, time) : ping.range_m === null ? words.silentUpTo(ping.trusted_range_m) : '';
  return { name: 'echo', title: ping.outcome === 'no_echo' ? words.parts.noEcho : words.parts.echo, value, line, strong: isTimed ? metres(ping.range_m) : '' };
}

function arc(s: Stepped): PartLine {
  if (!s.arc && s.ping.outcome === 'no_echo') return { name: 'cone', title: words.parts.cone, value: words.clears(s.ping.trusted_range_m), line: words.noArc, strong: '' };
  return { name: 'arc', title: words.parts.arc, value: s.arc ? words.arcLong(s.arc.length_m) : '', line: words.somewhere, strong: '' };
}

export function changeCounts(s: Stepped): { fuller: number; emptier: number; same: number } {
  const fuller = s.cells.filter((c) => gain(c, s.unit) > 0).length;
  const emptier = s.cells.filter((c) => gain(c, s.unit) < 0).length;
  return { fuller, emptier, same: s.cells.length - fuller - emptier };
}

/** Of methods without cells the other arcs are what a ping meets. */
export const speaksOfCells = (s: Stepped): boolean => s.cell_m !== null || s.cells.length > 0;

function changes(s: Stepped): PartLine {
  if (speaksOfCells(s)) {
    const { fuller, emptier } = changeCounts(s);
    const parts = [fuller > 0 && `${words.cells(fuller)}${words.getFuller(fuller)}`, emptier > 0 && `${words.cells(emptier)}${words.getEmptier(emptier)}`].filter((part) => part !== false);
    return { name: 'cells', title: words.parts.cells, value: words.cells(s.cells.length), line: parts.join(', '), strong: '' };
  }
  if (s.arcs.length === 0) return { name: 'adds', title: words.parts.nothingTouched, value: s.points.length > 0 ? words.points(s.points.length) : '', line: s.summary === '' ? words.noArcs : s.summary, strong: '' };
  const crossed = s.arcs.some((a) => a.what === 'crossed');
  const cut = s.arcs.some((a) => a.what !== 'crossed');
  const title = crossed && cut ? words.arcsBoth : crossed ? words.arcsCrossed : words.arcsCut;
  return { name: 'arcs', title, value: words.arcs(new Set(s.arcs.map((a) => a.ping.ping)).size), line: '', strong: '' };
}

export function partLines(s: Stepped): PartLine[] {
  const [x, y, yaw] = s.ping.T_world_tx;
  const sensor: PartLine = { name: 'sensor', title: words.parts.sensor, value: words.metresOf(x, y), line: words.facing(yaw), strong: '' };
  const after: PartLine = { name: 'after', title: words.parts.after, value: s.points.length > 0 ? words.points(s.points.length) : '', line: '', strong: '' };
  const all = [echo(s), sensor, arc(s), changes(s), after];
  const used = s.used ? partCount : s.ping.outcome === 'rejected' ? 1 : 3;
  return all.map((part, i) => (i < used ? part : { ...part, value: words.notUsed, line: '', strong: '' }));
}

/** The part after this one, in words; null after the last. */
export function nextPart(s: Stepped, part: number): string | null {
  if (part >= lastPart(s)) return null;
  const name = partLines(s)[part]?.name ?? 'after';
  return words.nextParts[name === 'echo' ? 'after' : name];
}
