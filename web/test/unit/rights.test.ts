// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

import { beforeEach, expect, test, vi } from 'vitest';
import type { FromClient } from '../../src/protocol/messages.ts';
import type { ToastAction } from '../../src/ui/toast.ts';

interface Shown { text: string; actions: readonly ToastAction[]; isError: boolean; forMs: number }
const shown: Shown[] = [];
vi.mock('../../src/ui/toast.ts', () => ({
  toast: (text: string, actions: readonly ToastAction[] = [], isError = false, forMs = 5000) => { shown.push({ text, actions, isError, forMs }); },
}));
vi.mock('../../src/ui/popover.ts', () => ({ dialog: () => undefined, menu: () => undefined }));

const { followRights } = await import('../../src/drive/rights.ts');

function rights(): { tell: (topic: string, change: object) => void; sent: FromClient[] } {
  const listeners = new Map<string, () => void>();
  const sent: FromClient[] = [];
  const model = { on: (topic: string, listener: () => void) => listeners.set(topic, listener), send: (message: FromClient) => sent.push(message) };
  followRights({ model, driving: { isWindingDown: false, take: () => sent.push({ type: 'take' }) } } as unknown as Parameters<typeof followRights>[0]);
  return { sent, tell: (topic, change) => { Object.assign(model, change); listeners.get(topic)?.(); } };
}

beforeEach(() => { shown.length = 0; });

test('who drives is asked as long as the server waits for an answer', () => {
  const { tell, sent } = rights();
  tell('drive_request', { driveRequest: { type: 'drive_request', viewer: 2, name: 'Viewer 2', timeout_s: 20 } });
  expect(shown[0]).toMatchObject({ text: 'Viewer 2 asks to drive', forMs: 20_000, isError: false });
  expect(shown[0]?.actions.map((a) => a.label)).toEqual(['Hand over', 'Keep']);
  shown[0]?.actions.forEach((a) => a.run());
  expect(sent).toEqual([{ type: 'answer', accept: true }, { type: 'answer', accept: false }]);
});

test('why one does not drive is said; after the dead man one may take it again', () => {
  const { tell, sent } = rights();
  for (const reason of ['kept', 'handed_over', 'dead_man']) tell('drive_lost', { driveLost: { type: 'drive_lost', reason } });
  expect(shown.map((s) => s.text)).toEqual(['The driver keeps driving.', 'You handed over.', expect.stringMatching(/^You no longer drive: nothing reached the robot/)]);
  shown[2]?.actions[0]?.run();
  expect(sent).toEqual([{ type: 'take' }]);
});
