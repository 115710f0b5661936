// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

import { Connection } from '../net/connection.ts';
import { Questions } from '../net/questions.ts';
import { Receiver } from '../net/receiver.ts';
import type { FromClient, FromServer } from '../protocol/messages.ts';
import { defaultShown, defaultView } from './defaults.ts';
import { HeldMaps } from './held_maps.ts';
import { Live } from './live.ts';
import type { MethodMap } from './method_map.ts';
import type { AnswerFrames, Model, Question, Topic, View } from './model.ts';
import { Topics } from './topics.ts';
import { isOptionKey, optionKeys } from './url_options.ts';
import { parseHash, writeHash } from './url_state.ts';

const tokenKey = 'echoarc.token';
const askTimeoutMs = 10_000;
/** Browsers refuse more than some hundred changes of the URL in half a minute. */
const urlIntervalMs = 400;

export class PageModel implements Model {
  readonly view: View;
  token: string | null;
  private others: [string, string][];
  private themeChosen: boolean;
  private shownChosen: boolean;
  private urlTimer: ReturnType<typeof setTimeout> | undefined;
  private readonly topics = new Topics();
  private readonly net: Connection;
  private readonly live: Live;
  private readonly receiver: Receiver;
  private readonly questions: Questions;
  private readonly heldMaps: HeldMaps;

  constructor() {
    const url = parseHash(location.hash);
    this.view = { ...defaultView(matchMedia('(prefers-color-scheme: dark)').matches), ...url.view };
    this.others = url.others;
    this.themeChosen = url.view.theme !== undefined;
    this.shownChosen = url.view.shown !== undefined;
    if (url.token !== null) sessionStorage.setItem(tokenKey, url.token);
    this.token = sessionStorage.getItem(tokenKey);
    this.net = new Connection(socketUrl(this.room), {
      hello: () => ({ type: 'hello', protocol: 1, ...(this.token === null ? {} : { token: this.token }) }),
      message: (message) => this.hear(message),
      frame: (bytes) => this.receiver.frame(bytes),
      changed: () => this.topics.tell('connection'),
      broken: () => this.broken(),
      nextId: () => this.questions.nextId(),
    });
    this.live = new Live(this.net.state);
    this.receiver = new Receiver(this.live, (topic) => this.topics.tell(topic), (id) => this.questions.methodsOf(id));
    this.questions = new Questions((message) => this.send(message));
    this.heldMaps = new HeldMaps({
      ask: (question) => this.ask(question),
      framesOf: (id) => this.framesOf(id),
      methodNames: () => [...this.live.maps.keys()],
      changed: () => { for (const topic of ['map', 'pings', 'state'] as const) this.topics.tell(topic); },
    });
    this.writeUrl(false);
    addEventListener('popstate', () => this.readUrl());
    addEventListener('hashchange', () => this.readUrl());
  }

  get room(): string { return new URLSearchParams(location.search).get('room') ?? 'main'; }
  get connection() { return this.live.connection; }
  get welcome() { return this.live.welcome; }
  get state() { return this.live.state; }
  get plan() { return this.live.plan; }
  get counters() { return this.live.counters; }
  get methods() { return this.live.methods; }
  get scores() { return this.live.scores; }
  get scoreHistory() { return this.live.scoreHistory; }
  get viewers() { return this.live.viewers; }
  get timeline() { return this.live.timeline; }
  get recompute() { return this.live.recompute; }
  get pings() { return this.live.pings; }
  get maps(): ReadonlyMap<string, MethodMap> { return this.heldMaps.maps ?? this.live.maps; }
  get liveMaps(): ReadonlyMap<string, MethodMap> { return this.live.maps; }
  get path() { return this.live.path; }
  get pathLength() { return this.live.pathLength; }
  get laser() { return this.live.laser; }
  get driveRequest() { return this.live.driveRequest; }
  get driveLost() { return this.live.driveLost; }
  get refused() { return this.live.refused; }
  get held() { return this.heldMaps.moment; }
  get me(): number { return this.live.welcome?.you.viewer ?? -1; }
  /** What the URL holds beyond the view: `src`, changed options as `o.METHOD.OPTION`, and what is not known. */
  get urlOthers(): readonly [string, string][] { return this.others; }

  start(): void { this.net.start(); }
  retryNow(): void { this.net.retryNow(); }
  close(): void { this.net.close(); }
  on(topic: Topic, listener: () => void): () => void { return this.topics.on(topic, listener); }
  tell(topic: Topic): void { this.topics.tell(topic); }
  send(message: FromClient): boolean { return this.net.send(message); }
  framesOf(id: number): AnswerFrames | null { return this.live.answers.get(id); }

  ask<T>(question: Question, timeoutMs = askTimeoutMs): Promise<T> { return this.questions.ask<T>(question, timeoutMs); }

  show(change: Partial<View>, push = false): void {
    if (change.theme !== undefined) this.themeChosen = true;
    if (change.shown !== undefined) this.shownChosen = true;
    const heldBefore = this.view.heldAt;
    if (push) this.flushUrl(); // so that the step back leads to where the person was, not to where the URL was last written
    Object.assign(this.view, change);
    if (this.view.heldAt !== heldBefore) this.heldMaps.hold(this.view.heldAt);
    if (push) this.writeUrl(true);
    else this.urlTimer ??= setTimeout(() => this.flushUrl(), urlIntervalMs);
    this.topics.tell('view');
  }

  /** Sets or, with null, removes a key of the URL that is not of the view. */
  setUrlOther(key: string, value: string | null): void {
    this.others = this.others.filter(([known]) => known !== key);
    if (value !== null) this.others.push([key, value]);
    this.writeUrl(false);
  }

  /** A token that the person pasted; the connection is opened anew with it. */
  useToken(token: string): void {
    this.token = token;
    sessionStorage.setItem(tokenKey, token);
    this.net.close();
    this.net.start();
  }

  /** A link to what is seen and the options behind it, without the token. */
  link(): string {
    const seen = this.view.name === 'compare' ? this.view.compare.methods : this.view.shown;
    const others = [...this.others.filter(([key]) => !isOptionKey(key)), ...optionKeys(seen, this.methods, this.welcome?.catalogue ?? [])];
    return `${location.origin}${location.pathname}${location.search}#${writeHash(this.view, others, this.themeChosen)}`;
  }

  private hear(message: FromServer): void {
    if (this.questions.answer(message)) {
      if (message.type === 'error') return; // who asked was told
    }
    this.receiver.message(message);
    if (message.type === 'methods') {
      if (!this.shownChosen) this.view.shown = defaultShown(message);
      if (this.view.heldAt !== null && !this.heldMaps.moment) this.heldMaps.hold(this.view.heldAt);
      this.topics.tell('view');
    }
  }

  private broken(): void {
    this.net.state.pingsWhenLost = this.live.state?.pings ?? 0;
    this.questions.abandon();
  }

  private hash(): string {
    return writeHash(this.shownChosen ? this.view : { ...this.view, shown: [] }, this.others, this.themeChosen);
  }

  private flushUrl(): void {
    if (this.urlTimer === undefined) return;
    clearTimeout(this.urlTimer);
    this.writeUrl(false);
  }

  private writeUrl(push: boolean): void {
    this.urlTimer = undefined;
    const url = `${location.pathname}${location.search}#${this.hash()}`;
    if (push) history.pushState(null, '', url);
    else history.replaceState(null, '', url);
  }

  private readUrl(): void {
    const url = parseHash(location.hash);
    this.others = url.others;
    const fresh = defaultView(this.view.theme === 'dark');
    if (!url.view.shown) fresh.shown = this.shownChosen || !this.live.methods ? this.view.shown : defaultShown(this.live.methods);
    const heldBefore = this.view.heldAt;
    Object.assign(this.view, fresh, url.view);
    if (this.view.heldAt !== heldBefore) this.heldMaps.hold(this.view.heldAt);
    if (url.token !== null) {
      this.writeUrl(false);
      this.useToken(url.token);
    }
    this.topics.tell('view');
  }
}

function socketUrl(room: string): string {
  const scheme = location.protocol === 'https:' ? 'wss' : 'ws';
  return `${scheme}://${location.host}/ws?room=${encodeURIComponent(room)}`;
}

export function createModel(): PageModel { return new PageModel(); }
