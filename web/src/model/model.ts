// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/**
 * All that the page knows, and what it is told to show. Parts subscribe to topics and read; only `net/` writes what came
 * over the wire, and only actions of the person (or the URL) write `view`.
 */
import type {
  Counters, DriveLost, DriveRequest, Error as Refusal, Explain, FromClient, Methods, Open, Pings, Plan, Pose, Recompute, Scores, Snapshot,
  State, Step, Viewers, Welcome,
} from '../protocol/messages.ts';
import type { MethodMap } from './method_map.ts';
import type { PingRecord, PingStore } from './ping_store.ts';

export type Topic =
  | 'connection' | 'welcome' | 'state' | 'plan' | 'counters' | 'methods' | 'scores' | 'timeline' | 'viewers' | 'pings'
  | 'map' | 'path' | 'laser' | 'view' | 'recompute' | 'drive_request' | 'drive_lost' | 'refused' | 'frame';

export type Phase = 'connecting' | 'live' | 'lost' | 'ended';

export interface ConnectionState {
  phase: Phase;
  /** performance.now() when the phase began. */
  sinceMs: number;
  attempt: number;
  /** performance.now() of the next attempt; NaN when none is due. */
  retryAtMs: number;
  roundTripMs: number;
  bytesPerS: number;
  /** Why it ended: of `bye`, or ''. */
  reason: '' | 'slow' | 'shutdown' | 'limit' | 'room_closed';
  /** Number of pings that the server had when the connection broke; to say what came in between. */
  pingsWhenLost: number;
  /** The server's version changed between two connections. */
  versionDiffers: boolean;
}

export interface Camera { x: number; y: number; /** pixels per metre, 8 to 600 */ s: number }

export type ViewName = 'map' | 'compare' | 'step' | 'explain' | 'sensor' | 'options';
export type LayerName = 'arcs' | 'bounds' | 'path' | 'plan' | 'truth' | 'laser';

/** What this page shows: the state in the URL (page design 8). */
export interface View {
  name: ViewName;
  /** Null: fit the map. */
  camera: Camera | null;
  follow: boolean;
  /** Methods on the map, the first is primary. */
  shown: string[];
  layers: Set<LayerName>;
  /** 'scan', '250', 's3' or 'r2': the last scan, the last 250 pings, those of one sensor, those rejected for one reason. */
  arcs: string;
  compare: { mode: 'side' | 'swipe' | 'blend'; blend: number; swipe: number; methods: string[] };
  /** Time of the source that is looked at; null: live. */
  heldAt: number | null;
  /** Ping, part (1 to 5) and cell of step mode. */
  ping: number | null;
  step: number;
  cell: { i: number; j: number } | null;
  /** Point (slot) or place that is explained. */
  explain: { method: string; slot: number | null; x: number; y: number } | null;
  sensor: number | null;
  /** Method whose options are open. */
  optionsOf: string | null;
  theme: 'light' | 'dark';
}

export interface Timeline { binS: number; echoes: number[]; noEchoes: number[]; rejected: number[] }
export interface ScoreSeries { t: number[]; maeM: number[] }

/** Questions are sent without an id: the model gives one. */
type WithoutId<M> = M extends unknown ? Omit<M, 'id'> : never;
export type Question = WithoutId<Open | Explain | Step | Pings | Snapshot>;

/** What came in binary frames as part of an answer. */
export interface AnswerFrames { maps: ReadonlyMap<string, MethodMap>; pings: readonly PingRecord[] }

/** The moment that is looked at instead of now. */
export interface HeldMoment { t: number; /** Number of pings until then. */ pings: number; pose: Pose | null; recent: readonly PingRecord[] }

export interface Model {
  readonly connection: ConnectionState;
  readonly welcome: Welcome | null;
  readonly state: State | null;
  /** Null while no strategy drives. */
  readonly plan: Plan | null;
  readonly counters: Counters | null;
  readonly methods: Methods | null;
  readonly scores: Scores | null;
  readonly scoreHistory: ReadonlyMap<string, ScoreSeries>;
  readonly viewers: Viewers | null;
  readonly timeline: Timeline;
  readonly recompute: ReadonlyMap<string, Recompute>;
  readonly pings: PingStore;
  /** By name of the method: the live maps, or those of the moment that is held. */
  readonly maps: ReadonlyMap<string, MethodMap>;
  /** Those of now, whatever is held: what `explain` speaks of. */
  readonly liveMaps: ReadonlyMap<string, MethodMap>;
  /** x, y, x, y, ... in world metres; `pathLength` numbers are used. */
  readonly path: Float32Array;
  readonly pathLength: number;
  readonly laser: Float32Array;
  readonly view: View;
  readonly token: string | null;
  /** Id of this viewer; -1 before the welcome. */
  readonly me: number;
  readonly driveRequest: DriveRequest | null;
  readonly driveLost: DriveLost | null;
  /** The newest refusal that answers no question of `ask`. */
  readonly refused: Refusal | null;
  /** Null while live, and until the first answer about a moment that is held. */
  readonly held: HeldMoment | null;

  on(topic: Topic, listener: () => void): () => void;
  /** Changes the view, tells 'view', and writes the URL; `push` makes a step of the history. */
  show(change: Partial<View>, push?: boolean): void;
  send(message: FromClient): boolean;
  /** Sends a question with a fresh id and resolves with its answer; rejects with the `error` message, or with a refusal of its own. */
  ask<T>(question: Question, timeoutMs?: number): Promise<T>;
  /** Maps and pings that came with an answer, by its id; of the newest few answers. */
  framesOf(id: number): AnswerFrames | null;
  /** Tries to connect at once. */
  retryNow(): void;
}
