// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Offers the options that a link asks for: they would change what everyone in the room sees. */
import { askForToken } from '../drive/rights.ts';
import { isOptionKey, optionWishes } from '../model/url_options.ts';
import { words } from '../words.ts';
import type { App } from './app.ts';
import { toast } from './toast.ts';

export function offerUrlOptions(app: App): void {
  const { model } = app;
  let offered = '';
  const keys = (): (readonly [string, string])[] => model.urlOthers.filter(([key]) => isOptionKey(key));
  const forget = (): void => { for (const [key] of keys()) model.setUrlOther(key, null); };
  const offer = (): void => {
    const { welcome, methods } = model;
    if (!welcome || !methods || keys().length === 0) return;
    const wishes = optionWishes(keys(), methods, welcome.catalogue);
    const key = JSON.stringify([wishes, welcome.you.viewer]);
    if (key === offered || wishes.length === 0) return;
    offered = key;
    const apply = (): void => {
      if (!welcome.you.may_drive) { askForToken(app); return; }
      for (const wish of wishes) model.send(wish);
      forget();
    };
    toast(words.linkOptions(wishes.map((wish) => app.titleOf(wish.method))), [{ label: words.apply, primary: true, run: apply }, { label: words.leaveAsIs, run: forget }]);
  };
  model.on('methods', offer);
  model.on('view', offer); // the URL may have been changed by hand
}
