// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** What the timeline and the charts show: bins of pings over the whole source, and errors as they developed. */
import type { History, Scores, Timeline as Bins } from '../protocol/messages.ts';
import type { ScoreSeries, Timeline } from './model.ts';

export function emptyTimeline(): Timeline { return { binS: 1, echoes: [], noEchoes: [], rejected: [] }; }

export function timelineOf(history: History): Timeline {
  return { binS: history.bin_s, echoes: [...history.echoes], noEchoes: [...history.no_echoes], rejected: [...history.rejected] };
}

/** Writes bins that changed; bins that were never told are empty. */
export function applyBins(timeline: Timeline, bins: Bins): void {
  const put = (into: number[], values: readonly number[]): void => {
    while (into.length < bins.first) into.push(0);
    values.forEach((value, i) => { into[bins.first + i] = value; });
  };
  put(timeline.echoes, bins.echoes);
  put(timeline.noEchoes, bins.no_echoes);
  put(timeline.rejected, bins.rejected);
}

export function seriesOf(history: History): Map<string, ScoreSeries> {
  return new Map(history.scores.map((s) => [s.method, { t: [...s.t], maeM: s.mae_m.map((m) => m ?? Number.NaN) }]));
}

export function appendScores(series: Map<string, ScoreSeries>, scores: Scores): void {
  for (const method of scores.methods) {
    const own = series.get(method.method) ?? { t: [], maeM: [] };
    series.set(method.method, own);
    // A replay that was wound back tells times again.
    while (own.t.length > 0 && (own.t.at(-1) ?? 0) >= scores.t) {
      own.t.pop();
      own.maeM.pop();
    }
    own.t.push(scores.t);
    own.maeM.push(method.mae_m ?? Number.NaN);
  }
}
