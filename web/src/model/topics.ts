// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

import type { Topic } from './model.ts';

/** Who wants to hear of what. A listener that throws does not keep the others from hearing. */
export class Topics {
  private readonly listeners = new Map<Topic, Set<() => void>>();

  on(topic: Topic, listener: () => void): () => void {
    const of = this.listeners.get(topic) ?? new Set();
    this.listeners.set(topic, of.add(listener));
    return () => { of.delete(listener); };
  }

  tell(topic: Topic): void {
    for (const listener of [...(this.listeners.get(topic) ?? [])]) {
      try {
        listener();
      } catch (error) {
        console.error(`A listener to '${topic}' failed.`, error);
      }
    }
  }
}
