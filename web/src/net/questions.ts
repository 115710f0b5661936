// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

import type { Question } from '../model/model.ts';
import type { Error as Refusal, FromClient, FromServer } from '../protocol/messages.ts';

interface Waiting { resolve: (answer: never) => void; reject: (refusal: Refusal) => void; timer: ReturnType<typeof setTimeout>; methods: readonly string[] }

const idLimit = 4294967295;

function refusal(id: number, code: string, message: string, remedy: string): Refusal {
  return { type: 'error', id, code, message, remedy };
}

function methodsIn(question: Question): readonly string[] {
  if ('methods' in question) return question.methods;
  return 'method' in question ? [question.method] : [];
}

/** Gives questions their ids and answers to who asked. */
export class Questions {
  private readonly waiting = new Map<number, Waiting>();
  private lastId = 0;

  constructor(private readonly send: (message: FromClient) => boolean) {}

  nextId(): number {
    this.lastId = this.lastId >= idLimit ? 1 : this.lastId + 1;
    return this.lastId;
  }

  ask<T>(question: Question, timeoutMs: number): Promise<T> {
    const id = this.nextId();
    return new Promise<T>((resolve, reject) => {
      if (!this.send({ ...question, id } as FromClient)) {
        reject(refusal(id, 'not_connected', 'The server cannot be reached.', 'Ask again once the connection is back.'));
        return;
      }
      const timer = setTimeout(() => {
        this.waiting.delete(id);
        reject(refusal(id, 'timeout', `No answer within ${timeoutMs / 1000} s.`, 'Ask again.'));
      }, timeoutMs);
      this.waiting.set(id, { resolve: resolve as Waiting['resolve'], reject, timer, methods: methodsIn(question) });
    });
  }

  /** True if someone waited for it. */
  answer(message: FromServer): boolean {
    const id = 'id' in message ? message.id : null;
    const who = id === null ? undefined : this.waiting.get(id);
    if (id === null || !who) return false;
    clearTimeout(who.timer);
    this.waiting.delete(id);
    if (message.type === 'error') who.reject(message);
    else who.resolve(message as never);
    return true;
  }

  /** The methods that a question asked about, in its order; frames of its answer say which by their place. */
  methodsOf(id: number): readonly string[] { return this.waiting.get(id)?.methods ?? []; }

  isWaiting(id: number): boolean { return this.waiting.has(id); }

  /** The connection broke: nobody will answer. */
  abandon(): void {
    for (const [id, who] of this.waiting) {
      clearTimeout(who.timer);
      who.reject(refusal(id, 'not_connected', 'The connection broke before the answer came.', 'Ask again once it is back.'));
    }
    this.waiting.clear();
  }
}
