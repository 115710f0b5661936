// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

import type { PingRecord } from '../../src/model/ping_store.ts';

export const ping = (id: number, change: Partial<PingRecord> = {}): PingRecord => ({
  id, t: id / 10, rx: id % 4, tx: id % 4, rangeM: 1, txX: 0, txY: 0, txYaw: 0, rxX: 0, rxY: 0, rxYaw: 0, robotX: 0, robotY: 0, robotYaw: 0,
  trustedM: 1, outcome: 'echo', reason: 0, ...change,
});
