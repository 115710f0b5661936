// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** "Why is this point here?": the panel of a point or a cell, and what it lights up on the map. */
import { type MarkSlot, markSlots } from '../map/slots.ts';
import type { MapPlace } from '../map/map_view.ts';
import { runningOf } from '../model/instances.ts';
import { backButton } from '../panels/back.ts';
import type { Explanation } from '../protocol/messages.ts';
import type { App, Panel } from '../ui/app.ts';
import { h } from '../ui/dom.ts';
import { clock } from '../ui/format.ts';
import { toast } from '../ui/toast.ts';
import { arcUnder } from './arc_hit.ts';
import { Inquiry } from './inquiry.ts';
import { replaceKeepingFocus } from './keep_focus.ts';
import { cellSection, factsOf, figureSection, lightUp, supportSection, titleOf } from './sections.ts';
import { words } from './words.ts';

type Handler = ((place: MapPlace | null) => void) | null;

class ExplainPanel implements Panel {
  readonly title = words.whySomething;
  private readonly heading = h('h1', { tabindex: -1 });
  private readonly sentence = h('p', { 'aria-live': 'polite' });
  private readonly note = h('div');
  private readonly facts = h('div');
  private readonly body = h('div', { class: 'explain-body' });
  private readonly foot = h('div', { class: 'foot', hidden: true });
  private readonly inquiry: Inquiry<Explanation>;
  private hovered: number | null = null;
  private drawn = '';
  private hoverBefore: Handler = null;
  private isMounted = false;
  private off: (() => void) | null = null;

  constructor(private readonly app: App) {
    this.inquiry = new Inquiry<Explanation>(app.model, () => this.draw());
  }

  mount(host: HTMLElement): void {
    this.isMounted = true;
    host.append(h('section', { class: 'sec' }, [backButton(this.app), this.heading, this.note, this.sentence, this.facts]), this.body, this.foot);
    this.hoverBefore = this.app.map.onHover;
    this.app.map.onHover = (place) => { this.hoverBefore?.(place); this.hoverMap(place); };
    this.off = this.app.model.on('welcome', () => { if (this.inquiry.refused) this.inquiry.forget(); this.update(); });
    this.update();
  }

  unmount(): void {
    this.isMounted = false;
    this.off?.();
    this.inquiry.stop();
    this.app.map.onHover = this.hoverBefore;
    this.app.map.setExplanation(null, null);
  }

  update(): void {
    const { explain } = this.app.model.view;
    if (explain) {
      const { method, slot, x, y } = explain;
      this.inquiry.wish(JSON.stringify(explain), slot === null ? { type: 'explain', method, x, y } : { type: 'explain', method, slot });
    }
    this.draw();
  }

  private draw(): void {
    if (!this.isMounted) return;
    const { answer, refused, slow, version } = this.inquiry;
    this.tellWhichMap();
    const key = `${version} ${answer ? this.slotOf(answer.method) : ''}`;
    if (key === this.drawn) return;
    this.drawn = key;
    if (!this.app.model.view.explain) this.say(words.whySomething, words.nothingChosen);
    else if (refused) this.showRefusal(refused.message, refused.remedy);
    else if (slow) this.say(answer ? titleOf(answer) : words.whySomething, words.lookingThrough(this.app.model.state?.pings ?? 0));
    else if (answer) this.show(answer);
    else this.say(words.whySomething, words.looking);
  }

  /** While a moment is held the map shows that; the server explains what it holds now. */
  private tellWhichMap(): void {
    const { heldAt } = this.app.model.view;
    const key = heldAt === null ? '' : clock(heldAt);
    if (this.note.dataset['of'] === key) return;
    this.note.dataset['of'] = key;
    const live = h('button', { class: 'btn sm' }, words.backToLive, { click: () => this.app.model.show({ heldAt: null }) });
    this.note.replaceChildren(...(heldAt === null ? [] : [h('div', { class: 'hint held-note' }, [h('p', {}, words.explainsLive(key)), live])]));
  }

  /** Title and sentence alone, where there is nothing to show below. */
  private say(title: string, sentence: string): void {
    this.heading.textContent = title;
    this.sentence.textContent = sentence;
    this.facts.replaceChildren();
    this.body.replaceChildren();
    this.foot.hidden = true;
    this.app.map.setExplanation(null, null);
  }

  private showRefusal(message: string, remedy: string): void {
    this.say(words.whySomething, message);
    const again = h('button', { class: 'btn' }, words.askAgain, { click: () => { this.inquiry.forget(); this.update(); } });
    this.body.append(h('section', { class: 'sec' }, [remedy !== '' && h('p', { class: 'hint' }, remedy), h('div', { class: 'row' }, [again])]));
  }

  private show(e: Explanation): void {
    this.heading.textContent = titleOf(e);
    this.sentence.textContent = e.sentence;
    this.facts.replaceChildren(factsOf(e));
    const sections = [figureSection(e, this.slotOf(e.method), runningOf(this.app.model.methods, e.method)?.name ?? e.method), supportSection(e, (ping) => this.hover(ping)), cellSection(e, this.app.titleOf)];
    replaceKeepingFocus(this.body, sections.filter((s) => s !== null));
    this.fillFoot(e);
    this.hovered = null;
    this.app.map.setExplanation(e, null);
  }

  /** Its mark on the map; it may change with what is shown. */
  private slotOf(method: string): MarkSlot { return markSlots(this.app.model.methods, this.app.model.view.shown).get(method) ?? 1; }

  private fillFoot(e: Explanation): void {
    const ping = e.own?.ping ?? e.cell?.changes.at(-1)?.ping ?? null;
    const method = e.kind === 'cell' && e.cell ? e.cell.method : e.method;
    const { shown } = this.app.model.view;
    const step = ping !== null && h('button', { class: 'btn grow' }, words.stepThrough(ping), {
      click: () => this.app.model.show({ name: 'step', ping, step: 1, cell: null, shown: [method, ...shown.filter((m) => m !== method)] }, true),
    });
    const copy = h('button', { class: 'btn quiet' }, words.copyLink, { click: () => void this.copyLink() });
    this.foot.replaceChildren(...(step ? [step, copy] : [copy]));
    this.foot.hidden = false;
  }

  private async copyLink(): Promise<void> {
    try {
      await navigator.clipboard.writeText(this.app.model.link());
      toast(words.linkCopied);
    } catch {
      toast(words.linkNotCopied, [], true);
    }
  }

  private hover(ping: number | null): void {
    const { answer } = this.inquiry;
    if (!answer || this.hovered === ping) return;
    this.hovered = ping;
    lightUp(this.body, ping);
    this.app.map.setExplanation(answer, ping);
  }

  private hoverMap(place: MapPlace | null): void {
    const { answer } = this.inquiry;
    if (answer) this.hover(place ? arcUnder(answer, place.x, place.y, this.app.map.camera.s) : null);
  }
}

export function createExplainPanel(app: App): Panel { return new ExplainPanel(app); }
