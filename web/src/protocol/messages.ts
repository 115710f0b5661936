// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// Made from schema/messages.schema.json by `npm run types`; edits are lost.

/**
 * docs/protocol.md says what a schema cannot.
 */
export type AnyMessage = (FromClient | FromServer)
export type FromClient = (Hello | Ping | Subscribe | Stop | Take | Release | Answer | Drive | Mode | MethodAdd | MethodRemove | Options | SensorSwitch | Playback | Open | Explain | Step | Pings | Snapshot)
export type FromServer = (Welcome | History | State | Plan | Counters | Methods | Recompute | Scores | Timeline | Viewers | DriveRequest | DriveLost | Pong | Error | Bye | Opened | PingsEnd | SnapshotEnd | Explanation | Stepped)
/**
 * x, y, yaw
 * 
 * @minItems 3
 * @maxItems 3
 */
export type Pose = [number, number, number]
/**
 * x, y
 * 
 * @minItems 2
 * @maxItems 2
 */
export type Point = [number, number]

/**
 * First message of a client.
 */
export interface Hello {
type: "hello"
protocol: 1
token?: string
name?: string
/**
 * as in `subscribe`
 * 
 * @maxItems 32
 */
methods?: string[]
}
/**
 * Asks for a sign of life.
 */
export interface Ping {
type: "ping"
id: number
}
/**
 * Whose maps are sent to this viewer; all without it.
 */
export interface Subscribe {
type: "subscribe"
/**
 * ids of running methods
 * 
 * @maxItems 32
 */
methods: string[]
}
/**
 * Brakes the robot. Needs no right.
 */
export interface Stop {
type: "stop"
}
/**
 * Wants to drive: at once when nobody does, else the driver is asked.
 */
export interface Take {
type: "take"
}
/**
 * Gives up driving, or hands it over.
 */
export interface Release {
type: "release"
to?: number
}
/**
 * The driver's answer to a request.
 */
export interface Answer {
type: "answer"
accept: boolean
}
/**
 * Wanted velocity of the driver, 20 times a second.
 */
export interface Drive {
type: "drive"
/**
 * m/s forwards
 */
v: number
/**
 * rad/s to the left
 */
w: number
seq?: number
}
/**
 * Starts a mode.
 */
export interface Mode {
type: "mode"
mode: string
x?: number
y?: number
}
/**
 * Adds a method, with its defaults or with options. One name may run several times under different ids.
 */
export interface MethodAdd {
type: "method_add"
/**
 * id that it shall have: a-z, 0-9, _ and -, a letter or digit first; its name, or none that is a method's
 */
method: string
/**
 * in the catalogue; that is the id, too, when it is left out
 */
name?: string
/**
 * what differs from the defaults
 */
options?: {
[k: string]: (boolean | number | string)
}
}
/**
 * Removes a method.
 */
export interface MethodRemove {
type: "method_remove"
/**
 * id of the running method
 */
method: string
}
/**
 * Sets options of a method; those not named get their defaults. The map is recomputed from the log.
 */
export interface Options {
type: "options"
/**
 * id of the running method
 */
method: string
options: {
[k: string]: (boolean | number | string)
}
}
/**
 * Turns a sensor off or on for the maps; they are recomputed.
 */
export interface SensorSwitch {
type: "sensor"
sensor: number
on: boolean
}
/**
 * Of a log: plays, pauses, sets the speed, seeks.
 */
export interface Playback {
type: "playback"
playing?: boolean
speed?: number
seek_s?: number
}
/**
 * Opens a scene in a new room.
 */
export interface Open {
type: "open"
id: number
scene: string
}
/**
 * Why is there something at a place? A point by its slot, or a cell by a position in it.
 */
export interface Explain {
type: "explain"
id: number
/**
 * id of the running method
 */
method: string
slot?: number
x?: number
y?: number
}
/**
 * What did this ping change?
 */
export interface Step {
type: "step"
id: number
/**
 * id of the running method
 */
method: string
ping: number
}
/**
 * Pings by id, as a binary frame with this id.
 */
export interface Pings {
type: "pings"
id: number
from: number
count: number
}
/**
 * The map as it was, as binary frames with this id; then the reply.
 */
export interface Snapshot {
type: "snapshot"
id: number
t: number
/**
 * ids of running methods
 * 
 * @maxItems 8
 */
methods: string[]
}
/**
 * Everything that does not change while the connection lasts.
 */
export interface Welcome {
type: "welcome"
protocol: 1
version: string
/**
 * changes when the server starts anew
 */
session: string
you: {
viewer: number
name: string
may_drive: boolean
}
source: Source
robot: Robot
catalogue: Method[]
modes: string[]
scenes: Scene[]
rejections: Rejection[]
labels: string[]
limits: {
upload_bytes: number
speed_m_s: number
turn_rate: number
dead_man_s: number
stop_deceleration_m_s2: number
}
}
export interface Source {
room: string
kind: ("scene" | "log")
name: string
title: string
drivable: boolean
has_truth: boolean
has_laser: boolean
duration_s: (number | null)
/**
 * true surfaces as polylines; empty when they are not known
 */
walls: [number, number][][]
}
export interface Robot {
name: string
radius_m: number
sensors: Sensor[]
}
/**
 * A sonar of the robot.
 */
export interface Sensor {
id: number
T_robot_sensor: Pose
beam_width: number
range_min_m: number
range_max_m: number
/**
 * pings per second as planned; null where no plan is known
 */
rate_hz: (number | null)
}
/**
 * A method of the catalogue.
 */
export interface Method {
name: string
title: string
short: string
summary: string
source: string
options: Option[]
/**
 * what to look for when it is compared with others
 */
look: string
}
/**
 * One option field of a method, as the catalogue declares it.
 */
export interface Option {
name: string
kind: ("boolean" | "integer" | "real" | "choice")
unit: string
default: (boolean | number | string)
min: (number | null)
max: (number | null)
choices: string[]
doc: string
source: string
}
export interface Scene {
name: string
title: string
}
export interface Rejection {
name: string
explanation: string
remedy: string
}
/**
 * What came before this viewer did.
 */
export interface History {
type: "history"
bin_s: number
echoes: number[]
no_echoes: number[]
rejected: number[]
scores: {
method: string
t: number[]
mae_m: (number | null)[]
}[]
}
/**
 * Ten times a second.
 */
export interface State {
type: "state"
tick: number
/**
 * time of the source
 */
t: number
/**
 * CLOCK_MONOTONIC of the server at this tick
 */
mono_us: number
pose: Pose
true_pose: (Pose | null)
v: number
w: number
mode: string
/**
 * why it does what it does: "", "obstacle", "arrived", "blocked", "dead man", "stopped", "finished" and "failed" (a strategy that ended), "end of log"
 */
reason: string
/**
 * that drives; while the robot stands: that ended here; else empty
 */
strategy: string
/**
 * what the strategy is doing, or why it ended; for people
 */
detail: string
goal: (Point | null)
driver: (number | null)
watchers: number
limit_m_s: number
limited_by: ("none" | "obstacle" | "stop")
free_ahead_m: (number | null)
stopped_by: ({
who: ("viewer" | "obstacle" | "dead_man" | "host")
viewer: (number | null)
name: string
} | null)
playing: boolean
speed: number
pings: number
/**
 * `seq` of the newest drive command that reached the robot
 */
drive_seq: (number | null)
/**
 * CLOCK_MONOTONIC when it did
 */
drive_mono_us: (number | null)
distance_m: number
}
/**
 * What the strategy that drives has in mind; when it changed, at most twice a second.
 */
export interface Plan {
type: "plan"
/**
 * empty: none drives, and nothing is planned
 */
strategy: string
/**
 * @maxItems 1000
 */
nodes: {
at: Point
/**
 * "meet", "boundary" and "pass" of a Voronoi graph, "frontier", "goal", "start"
 */
kind: string
}[]
/**
 * of a Voronoi graph, as far as they were driven
 */
edges: Point[][]
/**
 * planned way from the robot on
 */
path: Point[]
/**
 * where the robot takes itself to be: centre and axes, standard deviation along both
 */
estimate: ({
pose: Pose
deviation_m: Point
} | null)
/**
 * nodes and lines that did not fit
 */
left_out: number
}
/**
 * Once a second: where every ping went.
 */
export interface Counters {
type: "counters"
pings: number
echoes: number
no_echoes: number
too_close: number
waiting: number
rejected: Counts
rejected_odometry: Counts
sensors: {
id: number
echoes: number
no_echoes: number
too_close: number
rejected: Counts
rejected_last_minute: number
rate_hz: number
on: boolean
}[]
log: {
state: ("on" | "off" | "full" | "limit")
bytes: number
message: string
}
/**
 * states that this viewer was spared because it was slow
 */
dropped: number
}
export interface Counts {
[k: string]: number
}
/**
 * Which methods run; on change.
 */
export interface Methods {
type: "methods"
running: {
/**
 * id of this running method: what all other messages call `method`
 */
method: string
/**
 * in `welcome.catalogue`
 */
name: string
/**
 * how people are told of it; different for each
 */
label: string
options: OptionValues
state: ("ok" | "recomputing" | "failed")
reason: string
grid: ({
cell_m: number
x_m: number
y_m: number
} | null)
/**
 * it is a method of points, not of cells
 */
points: boolean
}[]
}
export interface OptionValues {
[k: string]: (boolean | number | string)
}
/**
 * How far a recomputation is.
 */
export interface Recompute {
type: "recompute"
/**
 * id of the running method
 */
method: string
done: number
total: number
}
/**
 * Once a second.
 */
export interface Scores {
type: "scores"
t: number
/**
 * why there are no scores; empty when there are
 */
reason: string
methods: {
method: string
points: number
bound_m: (number | null)
mae_m: (number | null)
p95_m: (number | null)
found: (number | null)
cpu_ms_per_ping: (number | null)
}[]
}
/**
 * Once a second: bins that changed.
 */
export interface Timeline {
type: "timeline"
first: number
echoes: number[]
no_echoes: number[]
rejected: number[]
}
/**
 * Who is here; on change.
 */
export interface Viewers {
type: "viewers"
viewers: Viewer[]
}
export interface Viewer {
viewer: number
name: string
driver: boolean
asking: boolean
}
/**
 * To the driver: someone asks to drive.
 */
export interface DriveRequest {
type: "drive_request"
viewer: number
name: string
timeout_s: number
}
/**
 * To one who drove, or asked to.
 */
export interface DriveLost {
type: "drive_lost"
reason: ("dead_man" | "handed_over" | "kept" | "stopped")
}
/**
 * Answer to ping.
 */
export interface Pong {
type: "pong"
id: number
mono_us: number
}
/**
 * Something was refused.
 */
export interface Error {
type: "error"
id: (number | null)
code: string
message: string
remedy: string
}
/**
 * Last message before the server closes the connection.
 */
export interface Bye {
type: "bye"
reason: ("slow" | "shutdown" | "limit" | "room_closed")
}
/**
 * Answer to open.
 */
export interface Opened {
type: "opened"
id: number
room: string
}
/**
 * Answer to pings, after the frame.
 */
export interface PingsEnd {
type: "pings_end"
id: number
}
/**
 * Answer to snapshot, after the frames.
 */
export interface SnapshotEnd {
type: "snapshot_end"
id: number
t: number
pings: number
pose: (Pose | null)
}
/**
 * Answer to explain.
 */
export interface Explanation {
type: "explanation"
id: number
method: string
kind: ("point" | "cell")
sentence: string
x: number
y: number
/**
 * that was asked about; null: a place was
 */
slot: (number | null)
label: string
bound_m: (number | null)
probability: (number | null)
off_wall_m: (number | null)
/**
 * the ping whose arc the point lies on
 */
own: (PingDetail | null)
arc: ({
t: number
t_begin: number
t_end: number
bound_t: (number | null)
} | null)
support: {
ping: PingDetail
t: (number | null)
angle: (number | null)
x: (number | null)
y: (number | null)
note: string
}[]
unused: {
reason: string
count: number
}[]
cell: ({
method: string
i: number
j: number
unit: string
value: number
probability: (number | null)
changes: CellChange[]
total: number
} | null)
searched: number
}
/**
 * One ping with all that is known of it.
 */
export interface PingDetail {
ping: number
t: number
tx: number
rx: number
range_m: (number | null)
outcome: ("no_echo" | "echo" | "too_close" | "rejected")
reason: (string | null)
T_world_tx: Pose
T_world_rx: Pose
T_world_robot: Pose
beam_width: number
trusted_range_m: number
}
export interface CellChange {
ping: number
t: number
sensor: number
before: number
after: number
where: ("on" | "before" | "beside")
}
/**
 * Answer to step; the map before it comes as binary frames with the same id.
 */
export interface Stepped {
type: "stepped"
id: number
method: string
ping: PingDetail
used: boolean
reason: string
time_of_flight_s: (number | null)
speed_of_sound_m_s: number
/**
 * of the robot, when the ping was fired; null where it is not known
 */
true_pose: (Pose | null)
arc: ({
length_m: number
t_begin: number
t_end: number
} | null)
cell_m: (number | null)
unit: string
cells: {
i: number
j: number
x: number
y: number
before: number
after: number
terms: Term[]
}[]
formulas: Formula[]
arcs: {
ping: PingDetail
what: ("crossed" | "cut" | "removed")
x: (number | null)
y: (number | null)
t_begin: (number | null)
t_end: (number | null)
note: string
}[]
points: Point[]
summary: string
}
/**
 * A named number of a formula.
 */
export interface Term {
name: string
value: (number | null)
unit: string
}
/**
 * One line of a formula. `tree` is a nested list: ["eq"|"add"|"sub"|"mul"|"frac"|"pow"|"exp"|"ln"|"neg", ...trees], ["sym", text] a symbol, ["val", term] the value of a term of the chosen cell, ["num", number] or ["num", number, unit].
 */
export interface Formula {
words: string
tree: unknown[]
/**
 * term that it yields
 */
result: string
}
