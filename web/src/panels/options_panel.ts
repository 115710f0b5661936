// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** The form of a method's options, made from the fields that the server declares. */
import { defaultGathering } from '../model/instances.ts';
import type { Method, Option } from '../protocol/messages.ts';
import type { App, Panel } from '../ui/app.ts';
import { h } from '../ui/dom.ts';
import { capital, whole } from '../ui/format.ts';
import { words } from '../words.ts';
import { backButton } from './back.ts';
import { compareGathered } from './compare_panel.ts';
import { markOf } from './method_rows.ts';
import { changedOptions, displayUnit, fromSlider, optionTitle, parseNumber, shownNumber, toSlider, type Value } from './option_values.ts';

type Set = (value: Value) => void;

function numberInput(option: Option, value: number, disabled: boolean, set: Set): HTMLElement[] {
  const { unit } = displayUnit(option);
  const field = h('input', { value: shownNumber(option, value), 'aria-label': optionTitle(option), inputmode: 'decimal', disabled });
  const error = h('p', { class: 'wrong', role: 'alert' });
  const box = h('span', { class: 'in' }, [field, h('span', {}, unit)]);
  field.addEventListener('change', () => {
    const parsed = parseNumber(option, field.value);
    box.classList.toggle('bad', 'error' in parsed);
    error.textContent = 'error' in parsed ? parsed.error : '';
    if ('value' in parsed) set(parsed.value);
  });
  if (option.min === null || option.max === null) return [box, error];
  const slider = h('input', { type: 'range', class: 'slide', min: 0, max: 1, step: 'any', value: toSlider(option, value), 'aria-label': optionTitle(option), disabled });
  slider.setAttribute('aria-valuetext', `${shownNumber(option, value)} ${unit}`);
  slider.addEventListener('input', () => { field.value = shownNumber(option, fromSlider(option, Number(slider.value))); });
  slider.addEventListener('change', () => set(fromSlider(option, Number(slider.value))));
  const ends = h('div', { class: 'rgl' }, [h('span', {}, shownNumber(option, option.min)), h('span', {}, `default ${shownNumber(option, Number(option.default))}`), h('span', {}, shownNumber(option, option.max))]);
  return [box, slider, ends, error];
}

function choice(option: Option, value: Value, disabled: boolean, set: Set): HTMLElement {
  if (option.choices.length > 4) {
    const select = h('select', { class: 'field', 'aria-label': optionTitle(option), disabled }, option.choices.map((c) => h('option', { value: c, selected: c === value }, c)));
    select.addEventListener('change', () => set(select.value));
    return select;
  }
  return h('div', { class: 'sel', role: 'radiogroup', 'aria-label': optionTitle(option) }, option.choices.map((c) =>
    h('button', { role: 'radio', 'aria-checked': String(c === value), class: c === value ? 'on' : '', disabled }, c.replaceAll('_', ' '), { click: () => set(c) })));
}

function optionRow(option: Option, value: Value, disabled: boolean, set: Set): HTMLElement {
  const changed = value !== option.default;
  const head: (Node | false)[] = [h('label', { title: option.source }, optionTitle(option)), changed && h('button', { class: 'rs', disabled }, 'Reset', { click: () => set(option.default) })];
  const below: HTMLElement[] = [];
  if (option.kind === 'boolean') {
    const box = h('input', { type: 'checkbox', class: 'ck end', 'aria-label': optionTitle(option), checked: value === true, disabled });
    box.addEventListener('change', () => set(box.checked));
    head.push(box);
  } else if (option.kind === 'choice') below.push(choice(option, value, disabled, set));
  else {
    const [field, ...rest] = numberInput(option, Number(value), disabled, set);
    if (field) head.push(field);
    below.push(...rest);
  }
  return h('div', { class: `opt${changed ? ' chg' : ''}` }, [h('div', { class: 'hd' }, head), ...below, h('p', {}, capital(option.doc))]);
}

export function makeOptionsPanel(app: App): Panel {
  const title = h('h1', { class: 'named', tabindex: -1 }), summary = h('p'), form = h('section', { class: 'sec grow' }), progress = h('div', { class: 'sec recompute', hidden: true });
  const reset = h('button', { class: 'btn grow' });
  const compare = h('button', { class: 'btn', hidden: true }, words.withDefault);
  const current = (): { method: string; known: Method; options: Option[]; values: Record<string, Value> } | null => {
    const method = app.model.view.optionsOf ?? app.model.view.shown[0];
    const running = app.model.methods?.running.find((r) => r.method === method);
    const known = app.model.welcome?.catalogue.find((m) => m.name === running?.name);
    if (!method || !running || !known) return null;
    return { method, known, options: known.options, values: { ...Object.fromEntries(known.options.map((o) => [o.name, o.default])), ...running.options } };
  };
  const apply = (name: string, value: Value): void => {
    const now = current();
    if (now) app.model.send({ type: 'options', method: now.method, options: changedOptions(now.options, { ...now.values, [name]: value }) });
  };
  let key = '';
  const fill = (): void => {
    const now = current();
    const mayChange = app.model.welcome?.you.may_drive ?? false;
    const next = JSON.stringify([now?.method, now?.values, mayChange]);
    if (!now || next === key) return;
    key = next;
    title.replaceChildren(markOf(app, now.method), app.titleOf(now.method));
    summary.textContent = [now.known.summary, now.known.source].filter(Boolean).join(' ');
    form.replaceChildren(...(mayChange ? [] : [h('div', { class: 'hint' }, words.onlyDriver)]), ...now.options.map((o) => optionRow(o, now.values[o.name] ?? o.default, !mayChange, (value) => apply(o.name, value))));
    const count = Object.keys(changedOptions(now.options, now.values)).length;
    reset.textContent = `Reset ${count} changed`;
    reset.disabled = count === 0 || !mayChange;
    compare.hidden = count === 0;
  };
  const showProgress = (): void => {
    const now = current();
    const running = app.model.methods?.running.find((r) => r.method === now?.method);
    const work = now ? app.model.recompute.get(now.method) : undefined;
    progress.hidden = !work || running?.state !== 'recomputing';
    if (!work || progress.hidden) return;
    const bar = h('progress', { max: work.total, value: work.done, 'aria-label': 'Recomputing' });
    progress.replaceChildren(h('div', { class: 'h2' }, ['Recomputing from the log', h('span', { class: 'r num' }, `${whole(work.done)} of ${whole(work.total)}`)]), bar, h('p', {}, words.mapSwitches));
  };
  reset.addEventListener('click', () => { const now = current(); if (now) app.model.send({ type: 'options', method: now.method, options: {} }); });
  compare.addEventListener('click', () => { const now = current(); if (now) compareGathered(app, defaultGathering(app.model.methods, now.known, now.method), 'swipe'); });
  const update = (): void => { fill(); showProgress(); };
  return {
    title: 'Options', update, unmount: () => undefined,
    mount(host) {
      host.append(h('section', { class: 'sec' }, [backButton(app), title, summary]), form, h('section', { class: 'sec' }, [
        h('button', { class: 'btn quiet' }, 'Remove method', { click: () => { const now = current(); if (now) { app.model.send({ type: 'method_remove', method: now.method }); app.model.show({ name: 'map' }, true); } } })]), progress, h('div', { class: 'foot' }, [reset, compare]));
      update();
    },
  };
}
