// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

import { describe, expect, it } from 'vitest';
import { keysToVelocity, padToVelocity, stickToVelocity } from '../../src/drive/velocity.ts';
import { changedOptions, fromSlider, parseNumber, toSlider } from '../../src/panels/option_values.ts';
import type { Option } from '../../src/protocol/messages.ts';
import { clock, heading, share, spokenTime } from '../../src/ui/format.ts';

const guard: Option = { name: 'guard', kind: 'real', unit: 'm', default: 0.013, min: 0, max: 0.05, choices: [], doc: '', source: '' };

describe('velocity', () => {
  it('adds held keys and slows with Shift', () => {
    expect(keysToVelocity(new Set(['KeyW', 'KeyA']), 0.5, 1, false)).toEqual({ v: 0.5, w: 1 });
    expect(keysToVelocity(new Set(['KeyW', 'ArrowUp']), 0.5, 1, true).v).toBeCloseTo(0.15);
    expect(keysToVelocity(new Set(['KeyW', 'KeyS']), 0.5, 1, false).v).toBe(0);
  });
  it('has a dead zone and full speed at the rim', () => {
    expect(padToVelocity(5, 5, 50, 0.5, 1)).toEqual({ v: 0, w: 0 });
    expect(padToVelocity(0, -50, 50, 0.5, 1).v).toBeCloseTo(0.5);
    expect(padToVelocity(0, -25, 50, 1, 1).v).toBeCloseTo(0.3536, 3);
    expect(padToVelocity(50, 0, 50, 0.5, 1).w).toBeCloseTo(-1);
    expect(stickToVelocity(0.1, 0, 1, 1)).toBeNull();
  });
});

describe('options', () => {
  it('reads what is typed in the unit that is shown', () => {
    expect(parseNumber(guard, '2.5')).toEqual({ value: 0.025 });
    expect(parseNumber(guard, '6')).toEqual({ error: 'From 0 to 5 cm' });
    expect(parseNumber(guard, 'x')).toEqual({ error: 'From 0 to 5 cm' });
  });
  it('goes to the slider and back', () => {
    const wide = { ...guard, min: 0.001, max: 10 };
    for (const option of [guard, wide]) expect(fromSlider(option, toSlider(option, 0.02))).toBeCloseTo(0.02, 5);
    expect(toSlider(wide, 0.1)).toBeCloseTo(0.5);
  });
  it('sends only what differs', () => {
    expect(changedOptions([guard], { guard: 0.013 })).toEqual({});
    expect(changedOptions([guard], { guard: 0.02 })).toEqual({ guard: 0.02 });
  });
});

describe('words of numbers', () => {
  it('writes times, shares and headings', () => {
    expect(clock(128.9)).toBe('2:08');
    expect(spokenTime(86)).toBe('1 minute 26');
    expect(share(46, 3211)).toBe('1.4%');
    expect(heading(-Math.PI / 2)).toBe('south');
  });
});
