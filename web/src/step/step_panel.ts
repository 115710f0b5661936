// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Step mode: one ping, from the echo to the map after it. */
import { Inquiry } from '../explain/inquiry.ts';
import { replaceKeepingFocus } from '../explain/keep_focus.ts';
import { backButton } from '../panels/back.ts';
import type { Stepped } from '../protocol/messages.ts';
import type { App, Panel } from '../ui/app.ts';
import { h } from '../ui/dom.ts';
import { icon } from '../ui/icons.ts';
import { cellAfter, type CellIndex, chosenCell, pingAfter } from './cells.ts';
import { lastPart, nextPart } from './parts.ts';
import { stepList } from './step_list.ts';
import { switchGroup } from './switches.ts';
import { words } from './words.ts';

/** What keys do while the panel is shown. */
export interface StepPanel extends Panel {
  next(): void;
  back(): void;
  previousPing(n: number): void;
  nextPing(n: number): void;
}

const askTimeoutMs = 20_000;
const urlTimeStepS = 0.01;
const ownArrows = 'input, textarea, select, [role=radio], [role=slider], [role=menu], [role=listbox], dialog, dialog *';

class Stepping implements StepPanel {
  readonly title = words.noTitle;
  private readonly heading = h('h1', { tabindex: -1 });
  private readonly sentence = h('p', { 'aria-live': 'polite' });
  private readonly choices = h('div', { class: 'step-choices' });
  private readonly body = h('section', { class: 'sec grow step-body-section' });
  private readonly foot = h('div', { class: 'foot' });
  private readonly inquiry: Inquiry<Stepped>;
  private ray = false;
  private truePose = false;
  private drawn = '';
  private shownPart: number | null = null;
  private isMounted = false;
  private heldBefore: number | null = null;
  private heldHere: number | null = null;
  private off: (() => void) | null = null;
  private readonly onKey = (event: KeyboardEvent): void => this.key(event);

  constructor(private readonly app: App) {
    this.inquiry = new Inquiry<Stepped>({ ask: (question) => app.model.ask(question, askTimeoutMs) }, () => this.draw());
  }

  mount(host: HTMLElement): void {
    this.isMounted = true;
    this.heldBefore = this.app.model.view.heldAt;
    host.append(h('section', { class: 'sec' }, [backButton(this.app), this.heading, this.sentence, this.choices]), this.body, this.foot);
    this.app.map.onStepCell = (cell) => this.app.model.show({ cell, step: 4 });
    addEventListener('keydown', this.onKey, true);
    this.off = this.app.model.on('welcome', () => { if (this.inquiry.refused) this.inquiry.forget(); this.update(); });
    this.update();
  }

  unmount(): void {
    this.isMounted = false;
    this.off?.();
    this.inquiry.stop();
    removeEventListener('keydown', this.onKey, true);
    this.app.map.onStepCell = null;
    this.app.map.setStep(null, 1, null, { ray: false, truePose: false });
    const { heldHere, heldBefore, app: { model } } = this;
    // Time goes on as before; not from within the change of the view that closes this panel.
    if (heldHere !== null) queueMicrotask(() => { if (model.view.heldAt === heldHere) model.show({ heldAt: heldBefore }); });
  }

  update(): void {
    const { model } = this.app;
    const ping = model.view.ping ?? this.newestEcho();
    if (ping !== null && model.view.ping === null) { model.show({ ping }); return; }
    const method = this.method();
    if (ping !== null && method !== null) {
      const options = model.methods?.running.find((r) => r.method === method)?.options ?? {};
      this.inquiry.wish(JSON.stringify([method, ping, options]), { type: 'step', method, ping });
    }
    this.draw();
  }

  next(): void {
    const s = this.inquiry.answer;
    if (!s) return;
    const part = this.part(s);
    if (part >= lastPart(s)) this.nextPing(1, 1);
    else this.go(part + 1);
  }

  back(): void {
    const s = this.inquiry.answer;
    const part = s ? this.part(s) : 1;
    if (part > 1) this.go(part - 1);
  }

  previousPing(n: number): void { this.nextPing(-n); }

  nextPing(n: number, step?: number): void {
    const { model } = this.app;
    const ping = pingAfter(model.view.ping ?? 0, n, model.state?.pings ?? 0);
    if (ping !== model.view.ping) model.show({ ping, cell: null, ...(step === undefined ? {} : { step }) });
  }

  private go(part: number): void { this.app.model.show({ step: part }); }

  private part(s: Stepped): number { return Math.max(1, Math.min(lastPart(s), this.app.model.view.step)); }

  /** The primary method; of those that run. */
  private method(): string | null {
    const running = this.app.model.methods?.running.map((r) => r.method) ?? [];
    return this.app.model.view.shown.find((m) => running.includes(m)) ?? running[0] ?? null;
  }

  private newestEcho(): number | null {
    const { pings } = this.app.model;
    return pings.recent.findLast((p) => p.outcome === 'echo')?.id ?? pings.newest?.id ?? null;
  }

  private draw(): void {
    if (!this.isMounted) return;
    const { view, methods } = this.app.model;
    const key = JSON.stringify([this.inquiry.version, view.ping, view.step, view.cell, this.ray, this.truePose, this.method(), methods?.running.map((r) => r.method)]);
    if (key === this.drawn) return;
    this.drawn = key;
    const { answer, refused, slow } = this.inquiry;
    if (view.ping === null) this.say(words.noTitle, words.noPings);
    else if (refused) this.showRefusal(view.ping, refused.message, refused.remedy);
    else if (slow || !answer) this.say(words.title(view.ping), slow ? words.goingBack(view.ping) : '');
    else this.show(answer);
  }

  private say(title: string, sentence: string): void {
    this.heading.textContent = title;
    this.sentence.textContent = sentence;
    this.body.replaceChildren();
    this.foot.hidden = true;
    replaceKeepingFocus(this.choices, this.methodChoice());
  }

  private showRefusal(ping: number, message: string, remedy: string): void {
    this.say(words.title(ping), message);
    this.app.map.setStep(null, 1, null, { ray: false, truePose: false });
    const again = h('button', { class: 'btn' }, words.askAgain, { click: () => { this.inquiry.forget(); this.update(); } });
    this.body.append(...(remedy === '' ? [] : [h('p', { class: 'hint' }, remedy)]), h('div', { class: 'row' }, [again]));
  }

  private show(s: Stepped): void {
    const { model } = this.app;
    const part = this.part(s);
    const cell = chosenCell(s.cells, model.view.cell, s.unit);
    const sensor = s.ping.tx === s.ping.rx ? String(s.ping.rx) : `${s.ping.tx} → ${s.ping.rx}`;
    this.heading.textContent = words.title(s.ping.ping);
    this.sentence.textContent = words.whatIs(sensor, s.ping.t, this.app.titleOf(s.method), s.cell_m);
    replaceKeepingFocus(this.choices, [...this.switches(s), ...this.methodChoice()]);
    const list = stepList(s, part, {
      cell, truePose: this.truePose, rejections: model.welcome?.rejections ?? [],
      moveCell: (by) => { if (cell) this.choose(cellAfter(s.cells, cell, by)); },
    }, (to) => this.go(to));
    replaceKeepingFocus(this.body, [list]);
    if (this.shownPart !== null && this.shownPart !== part) list.querySelector('.now')?.scrollIntoView({ block: 'nearest' });
    this.shownPart = part;
    this.fillFoot(s, part);
    this.app.map.setStep(s, part, cell && { i: cell.i, j: cell.j }, { ray: this.ray, truePose: this.truePose && s.true_pose !== null });
    this.hold(s.ping.t);
  }

  /** Time stands at the ping, once per ping: who goes back to now is not held again. */
  private hold(t: number): void {
    if (this.heldHere === t) return;
    const { heldAt } = this.app.model.view;
    // A link to this ping holds its time, too: leaving it leads to now.
    if (this.heldHere === null && heldAt !== null && Math.abs(heldAt - t) < urlTimeStepS) this.heldBefore = null;
    this.heldHere = t;
    if (heldAt !== t) this.app.model.show({ heldAt: t });
  }

  private choose(cell: CellIndex | null): void { if (cell) this.app.model.show({ cell: { i: cell.i, j: cell.j } }); }

  private switches(s: Stepped): HTMLElement[] {
    const isKnown = s.true_pose !== null;
    return [
      switchGroup(words.beam, [{ key: 'cone', label: words.cone }, { key: 'ray', label: words.ray }], this.ray ? 'ray' : 'cone', (key) => { this.ray = key === 'ray'; this.draw(); }),
      switchGroup(words.pose, [{ key: 'odometry', label: words.odometry }, { key: 'true', label: words.truePose, disabled: !isKnown, ...(isKnown ? {} : { title: words.noTruth }) }],
        this.truePose && isKnown ? 'true' : 'odometry', (key) => { this.truePose = key === 'true'; this.draw(); }),
    ];
  }

  private methodChoice(): HTMLElement[] {
    const running = this.app.model.methods?.running.filter((r) => r.state !== 'failed').map((r) => r.method) ?? [];
    const chosen = this.method();
    if (running.length < 2) return [];
    const choice = h('select', { class: 'field', 'aria-label': words.method, 'data-key': 'method' }, running.map((m) => h('option', { value: m, selected: m === chosen }, this.app.titleOf(m))), {
      change: () => this.app.model.show({ cell: null, shown: [choice.value, ...this.app.model.view.shown.filter((m) => m !== choice.value)] }),
    });
    return [choice];
  }

  private fillFoot(s: Stepped, part: number): void {
    const next = nextPart(s, part);
    this.foot.hidden = false;
    replaceKeepingFocus(this.foot, [
      h('button', { class: 'btn', 'data-key': 'back', disabled: part === 1 }, [icon('back'), words.back], { click: () => this.back() }),
      h('button', { class: 'btn pri grow', 'data-key': 'next' }, [next === null ? words.nextPing : words.next(next), h('kbd', {}, '→')], { click: () => this.next() }),
    ]);
  }

  private key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey || event.shiftKey || this.app.driving.active) return;
    if (event.key !== 'ArrowRight' && event.key !== 'ArrowLeft') return;
    if (event.target instanceof Element && event.target.closest(ownArrows)) return;
    event.preventDefault();
    event.stopPropagation();
    if (event.key === 'ArrowRight') this.next();
    else this.back();
  }
}

export function createStepPanel(app: App): StepPanel { return new Stepping(app); }
