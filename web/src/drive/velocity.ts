// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** From keys, the pad and the stick of a gamepad to a velocity. */
export interface Velocity { v: number; w: number }

const slowFactor = 0.3;
const deadZone = 0.15;
const exponent = 1.5;
export const driveKeys: Readonly<Record<string, readonly [forward: number, left: number]>> = {
  KeyW: [1, 0], ArrowUp: [1, 0], KeyS: [-1, 0], ArrowDown: [-1, 0], KeyA: [0, 1], ArrowLeft: [0, 1], KeyD: [0, -1], ArrowRight: [0, -1],
};

const clamp = (value: number): number => Math.max(-1, Math.min(1, value));

export function keysToVelocity(held: ReadonlySet<string>, maxV: number, maxW: number, slow: boolean): Velocity {
  let forward = 0;
  let left = 0;
  for (const key of held) {
    forward += driveKeys[key]?.[0] ?? 0;
    left += driveKeys[key]?.[1] ?? 0;
  }
  const factor = slow ? slowFactor : 1;
  return { v: clamp(forward) * maxV * factor, w: clamp(left) * maxW * factor };
}

const shaped = (share: number): number => Math.sign(share) * Math.abs(share) ** exponent;

/** `dx`, `dy` in pixels from the middle, down positive; `reach` is where the full speed is. */
export function padToVelocity(dx: number, dy: number, reach: number, maxV: number, maxW: number, deadPx = 8): Velocity {
  if (Math.hypot(dx, dy) < deadPx) return { v: 0, w: 0 };
  return { v: shaped(clamp(-dy / reach)) * maxV + 0, w: shaped(clamp(-dx / reach)) * maxW + 0 };
}

export function stickToVelocity(x: number, y: number, maxV: number, maxW: number): Velocity | null {
  if (Math.hypot(x, y) < deadZone) return null;
  return { v: shaped(clamp(-y)) * maxV, w: shaped(clamp(-x)) * maxW };
}
