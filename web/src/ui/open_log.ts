// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Log files: chosen, or dropped onto the page. They map in a room of their own. */
import { words } from '../words.ts';
import { askForToken } from '../drive/rights.ts';
import type { App } from './app.ts';
import { h } from './dom.ts';
import { toast } from './toast.ts';
import { goToRoom } from './top_bar.ts';

const readable = /\.(jsonl?|ndjson|log|txt|clf|csv|gz)$/i;

export async function upload(app: App, file: File): Promise<void> {
  const limit = app.model.welcome?.limits.upload_bytes ?? Number.POSITIVE_INFINITY;
  if (!readable.test(file.name)) { toast(words.unknownFile(file.name), [], true); return; }
  if (file.size > limit) { toast(words.tooLarge(file.size, limit), [], true); return; }
  if (!app.model.token) { askForToken(app); return; }
  try {
    const answer = await fetch('api/log', { method: 'POST', body: file, headers: { Authorization: `Bearer ${app.model.token}`, 'X-File-Name': encodeURIComponent(file.name) } });
    const body = (await answer.json()) as { room?: string; message?: string; error?: string; remedy?: string };
    if (answer.ok && body.room) goToRoom(body.room, `log:${file.name}`);
    else toast([body.message ?? body.error ?? words.unknownFile(file.name), body.remedy].filter(Boolean).join('. '), [], true);
  } catch {
    toast('The file did not reach the server.', [], true);
  }
}

export function openLog(app: App): void {
  const field = h('input', { type: 'file' });
  field.addEventListener('change', () => { const file = field.files?.[0]; if (file) void upload(app, file); });
  field.click();
}

export function mountDrop(app: App, over: HTMLElement): void {
  const title = h('b');
  const box = h('div', { class: 'drop', hidden: true }, [title, h('p', {}, words.dropBody)]);
  over.append(box);
  const isFile = (event: DragEvent): boolean => event.dataTransfer?.types.includes('Files') ?? false;
  addEventListener('dragover', (event) => {
    if (!isFile(event)) return;
    event.preventDefault();
    title.textContent = words.dropTitle('this log');
    box.hidden = false;
  });
  addEventListener('dragleave', (event) => { if (!event.relatedTarget) box.hidden = true; });
  addEventListener('drop', (event) => {
    event.preventDefault();
    box.hidden = true;
    const file = event.dataTransfer?.files[0];
    if (file) void upload(app, file);
  });
}
