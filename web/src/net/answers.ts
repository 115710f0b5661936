// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

import { MapStore } from '../model/map_store.ts';
import type { AnswerFrames } from '../model/model.ts';
import type { PingRecord } from '../model/ping_store.ts';

const kept = 6;

export class AnswerStore implements AnswerFrames {
  readonly maps = new Map<string, MapStore>();
  pings: PingRecord[] = [];

  map(method: string, name: string): MapStore {
    const known = this.maps.get(method);
    if (known) return known;
    const made = new MapStore(method, name);
    this.maps.set(method, made);
    return made;
  }
}

/** Frames that answer questions, by the question's id; the oldest go. */
export class Answers {
  private readonly byId = new Map<number, AnswerStore>();

  of(id: number): AnswerStore {
    const known = this.byId.get(id);
    if (known) return known;
    const made = new AnswerStore();
    this.byId.set(id, made);
    for (const old of this.byId.keys()) {
      if (this.byId.size <= kept) break;
      this.byId.delete(old);
    }
    return made;
  }

  get(id: number): AnswerStore | null { return this.byId.get(id) ?? null; }
}
