// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

export const outcomes = ['no_echo', 'echo', 'too_close', 'rejected'] as const;
export type OutcomeName = (typeof outcomes)[number];

/** A ping as the page draws it. */
export interface PingRecord {
  id: number; t: number; rx: number; tx: number; /** NaN where there is none */ rangeM: number;
  txX: number; txY: number; txYaw: number; rxX: number; rxY: number; rxYaw: number;
  robotX: number; robotY: number; robotYaw: number;
  trustedM: number; outcome: OutcomeName; /** index in welcome.rejections */ reason: number;
}

export interface PingStore {
  /** Oldest first; the newest some ten thousand. */
  readonly recent: readonly PingRecord[];
  readonly newest: PingRecord | null;
  byId(id: number): PingRecord | null;
  /** Those of one sensor (receiver) since a time, oldest first. */
  ofSensor(sensor: number, sinceT: number): PingRecord[];
}
