// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest';
import { asSentence, Inquiry } from '../../src/explain/inquiry.ts';
import type { Question } from '../../src/model/model.ts';

interface Asked { question: Question; resolve: (answer: unknown) => void; reject: (error: unknown) => void }

const question = (ping: number): Question => ({ type: 'step', method: 'evidence', ping });
const settled = async (): Promise<void> => { await Promise.resolve(); await Promise.resolve(); };

describe('a question', () => {
  let asked: Asked[] = [];
  let inquiry: Inquiry<string>;
  let changes = 0;

  beforeEach(() => {
    vi.useFakeTimers();
    asked = [];
    changes = 0;
    const ask = (q: Question): Promise<never> => new Promise((resolve, reject) => { asked.push({ question: q, resolve: resolve as Asked['resolve'], reject }); });
    inquiry = new Inquiry<string>({ ask }, () => { changes++; });
  });
  afterEach(() => { vi.useRealTimers(); });

  test('is asked once', async () => {
    inquiry.wish('a', question(1));
    inquiry.wish('a', question(1));
    expect(asked.length).toBe(1);
    asked[0]?.resolve('one');
    await settled();
    expect(inquiry.answer).toBe('one');
    inquiry.wish('a', question(1));
    expect(asked.length).toBe(1);
  });

  test('is called slow after 200 ms, until its answer is there', async () => {
    inquiry.wish('a', question(1));
    vi.advanceTimersByTime(199);
    expect(inquiry.slow).toBe(false);
    vi.advanceTimersByTime(1);
    expect(inquiry.slow).toBe(true);
    asked[0]?.resolve('one');
    await settled();
    expect(inquiry.slow).toBe(false);
    expect(changes).toBe(3);
  });

  test('the newest wish wins, and the old answer stays until then', async () => {
    inquiry.wish('a', question(1));
    asked[0]?.resolve('one');
    await settled();
    inquiry.wish('b', question(2));
    inquiry.wish('c', question(3));
    expect(inquiry.answer).toBe('one');
    asked[2]?.resolve('three');
    asked[1]?.resolve('two');
    await settled();
    expect(inquiry.answer).toBe('three');
  });

  test('a refusal is told in sentences, and can be asked again', async () => {
    inquiry.wish('a', question(1));
    asked[0]?.reject({ type: 'error', message: 'ping 1 is not in the log', remedy: 'ask for a smaller id' });
    await settled();
    expect(inquiry.refused).toEqual({ message: 'Ping 1 is not in the log.', remedy: 'Ask for a smaller id.' });
    expect(inquiry.answer).toBeNull();
    inquiry.forget();
    inquiry.wish('a', question(1));
    expect(asked.length).toBe(2);
    expect(inquiry.refused).toBeNull();
  });

  test('after its end nothing is told', async () => {
    inquiry.wish('a', question(1));
    inquiry.stop();
    asked[0]?.resolve('one');
    vi.advanceTimersByTime(1000);
    await settled();
    expect(changes).toBe(1);
  });
});

test('clauses become sentences', () => {
  expect(asSentence('ask again')).toBe('Ask again.');
  expect(asSentence('The server cannot be reached.')).toBe('The server cannot be reached.');
  expect(asSentence('')).toBe('');
});
