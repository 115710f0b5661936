// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** A question to the server and what has come of it: the newest wish wins, and its answer stays until a newer one is there. */
import type { Model, Question } from '../model/model.ts';
import { capital } from '../ui/format.ts';

const slowMs = 200;

export interface Refused { message: string; remedy: string }

/** What the server says as a clause, as a sentence. */
export function asSentence(clause: string): string {
  return clause === '' || /[.?]$/.test(clause) ? capital(clause) : `${capital(clause)}.`;
}

function refusedOf(error: unknown): Refused {
  const { message, remedy } = (error ?? {}) as { message?: unknown; remedy?: unknown };
  return { message: asSentence(typeof message === 'string' ? message : String(error)), remedy: asSentence(typeof remedy === 'string' ? remedy : '') };
}

export class Inquiry<Answer> {
  answer: Answer | null = null;
  refused: Refused | null = null;
  /** It is being looked for, and for longer than one would not notice. */
  slow = false;
  /** Grows with every change, to draw only what is new. */
  version = 0;
  private key = '';
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly model: Pick<Model, 'ask'>, private readonly changed: () => void) {}

  /** Asks once per key. */
  wish(key: string, question: Question): void {
    if (key === this.key) return;
    this.key = key;
    this.refused = null;
    clearTimeout(this.timer);
    this.slow = false;
    this.timer = setTimeout(() => { this.slow = true; this.tell(); }, slowMs);
    this.model.ask<Answer>(question).then(
      (answer) => { if (key === this.key) this.settle(answer, null); },
      (error: unknown) => { if (key === this.key) this.settle(null, refusedOf(error)); },
    );
    this.tell();
  }

  /** The next wish asks again, even for the same. */
  forget(): void { this.key = ''; }

  stop(): void {
    this.key = '';
    clearTimeout(this.timer);
  }

  private settle(answer: Answer | null, refused: Refused | null): void {
    clearTimeout(this.timer);
    this.slow = false;
    this.answer = answer;
    this.refused = refused;
    this.tell();
  }

  private tell(): void {
    this.version++;
    this.changed();
  }
}
