// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

import { mountStrip } from './dock/strip.ts';
import { mountTimeline } from './dock/timeline.ts';
import { Driving } from './drive/driving.ts';
import { mountPad } from './drive/pad.ts';
import { followRights } from './drive/rights.ts';
import { mountStop } from './drive/stop_button.ts';
import { createExplainPanel } from './explain/explain_panel.ts';
import { createMapView } from './map/map_view.ts';
import { createModel } from './model/page_model.ts';
import { makeComparePanel } from './panels/compare_panel.ts';
import { makeLivePanel } from './panels/live_panel.ts';
import { makeOptionsPanel } from './panels/options_panel.ts';
import { makeSensorPanel } from './panels/sensor_panel.ts';
import { createStepPanel } from './step/step_panel.ts';
import { methodShort, methodTitle, registerPanel, type App } from './ui/app.ts';
import { mountCompareBar } from './ui/compare_bar.ts';
import { byId } from './ui/dom.ts';
import { mountInspector } from './ui/inspector.ts';
import { mountKeyboard } from './ui/keyboard.ts';
import { mountMapClicks } from './ui/map_clicks.ts';
import { mountDrop } from './ui/open_log.ts';
import { mountModeChip } from './ui/mode_chip.ts';
import { mountEmpty, mountHint, mountNotice, mountLiveText, mountLost, mountMapControls } from './ui/overlays.ts';
import { openSheet } from './ui/sheet.ts';
import { toast } from './ui/toast.ts';
import { mountTopBar } from './ui/top_bar.ts';
import { offerUrlOptions } from './ui/url_options.ts';
import { words } from './words.ts';

function start(): void {
  const model = createModel();
  document.documentElement.dataset['theme'] = model.view.theme;
  const mapHost = byId('map');
  const over = byId('over');
  const map = createMapView(mapHost, model);
  const app: App = {
    model, map, mapHost, driving: new Driving(model), titleOf: (method) => methodTitle(model, method), shortOf: (method) => methodShort(model, method),
  };
  registerPanel('map', makeLivePanel);
  registerPanel('explain', createExplainPanel);
  registerPanel('step', createStepPanel);
  registerPanel('compare', makeComparePanel);
  registerPanel('options', makeOptionsPanel);
  registerPanel('sensor', makeSensorPanel);
  mountStop(app, byId('stop'));
  mountTopBar(app, byId('top'));
  mountInspector(app, byId('insp'));
  mountStrip(app, byId('sens'));
  mountTimeline(app, byId('tl'));
  const clicks = mountMapClicks(app);
  mountMapControls(app, over);
  mountModeChip(app, over, clicks.startGoTo);
  mountHint(app, over);
  mountCompareBar(app, over);
  mountNotice(app, over);
  mountEmpty(app, over);
  mountLost(app, over);
  mountDrop(app, over);
  const pad = mountPad(app, over);
  model.on('state', pad.update);
  app.driving.onChange = pad.update;
  followRights(app);
  offerUrlOptions(app);
  mountLiveText(app, byId('says'));
  mountKeyboard(app, {
    togglePad: pad.togglePad, toggleStrip: () => { document.body.toggleAttribute('data-no-strip'); }, startGoTo: clicks.startGoTo, cancel: clicks.cancel,
    walk: clicks.walk, explainWalked: clicks.explainWalked,
    focusLayers: () => { openSheet(); document.getElementById('layers')?.focus(); },
  });
  welcomeBack(app);
  if (!map.accelerated) toast(words.noWebGl);
  model.start();
}

/** Says what happened meanwhile when a broken connection is back. */
function welcomeBack(app: App): void {
  let lost = false;
  app.model.on('state', () => {
    if (!lost) return;
    lost = false;
    const missed = (app.model.state?.pings ?? 0) - app.model.connection.pingsWhenLost;
    if (app.model.connection.versionDiffers) toast(words.updated, [{ label: words.reload, primary: true, run: () => location.reload() }]);
    else if (missed >= 0) toast(words.backAgain(missed));
  });
  app.model.on('connection', () => { if (app.model.connection.phase === 'lost') lost = true; });
}

start();
