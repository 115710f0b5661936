// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

import { words } from '../words.ts';
import type { App } from './app.ts';
import { h } from './dom.ts';
import { menu } from './popover.ts';
import { toast } from './toast.ts';

async function download(path: string, name: string): Promise<void> {
  try {
    const answer = await fetch(path);
    if (!answer.ok) throw new Error(`The server answered ${answer.status}.`);
    saveBlob(await answer.blob(), name);
  } catch (error) {
    toast(error instanceof Error ? error.message : String(error), [], true);
  }
}

export function saveBlob(blob: Blob, name: string): void {
  const url = URL.createObjectURL(blob);
  h('a', { href: url, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
  toast(words.saved(name, blob.size));
}

export function saveMenu(app: App, opener: HTMLElement): void {
  const room = `?room=${encodeURIComponent(app.model.room)}`;
  const method = app.model.view.shown[0];
  const title = method ? app.titleOf(method) : '';
  const points = app.model.methods?.running.find((r) => r.method === method)?.points ?? false;
  const map = (kind: string): { label: string; note: string; run: () => void } => ({
    label: `${kind === 'yaml' ? 'YAML beside the PGM' : kind.toUpperCase()}${kind === 'csv' ? ' points' : ''}`, note: title,
    run: () => void download(`api/map/${encodeURIComponent(method ?? '')}.${kind}${room}`, `${method}.${kind}`),
  });
  menu(opener, words.saveMap, [
    { label: 'Picture of this view', run: () => void app.map.picture().then((blob) => saveBlob(blob, 'map.png')) },
    ...(method ? [map('png'), map('pgm'), map('yaml'), ...(points ? [map('csv')] : [])] : []),
    { label: 'Log', note: 'JSON Lines', run: () => void download(`api/log${room}`, 'session.jsonl') },
    { label: 'run.json', note: 'parameters', run: () => void download(`api/run.json${room}`, 'run.json') },
  ]);
}
