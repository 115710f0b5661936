// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Every text of step mode. */
import { unitWords } from '../formula/fullness.ts';
import { centimetres, count, decimals, degrees, direction, exactTime, length, metres, place, plainNumber, signedDegrees } from '../formula/numbers.ts';
import { capital, words as plain } from '../ui/format.ts';

const several = (n: number, one: string, many: string): string => `${count(n)} ${n === 1 ? one : many}`;

export const words = {
  title: (ping: number): string => `Ping ${count(ping)}, step by step`,
  noTitle: 'Step by step',
  noPings: 'No pings yet.',
  goingBack: (ping: number): string => `Going back to the map before ping ${count(ping)}`,
  askAgain: 'Ask again',
  whatIs: (sensor: string, t: number, method: string, cellM: number | null): string =>
    `Sensor ${sensor}, at ${exactTime(t)}. ${method}${cellM === null ? '' : `, ${decimals(cellM * 100, 0)} cm cells`}.`,
  beam: 'Beam', cone: 'Cone', ray: 'Ray',
  pose: 'Pose', odometry: 'Odometry', truePose: 'True pose', noTruth: 'The true pose is not known in this source',
  method: 'Method',
  parts: {
    echo: 'The echo', noEcho: 'No echo', sensor: 'Where the sensor was', arc: 'The arc', cone: 'What it clears',
    cells: 'The cells it changes', nothingTouched: 'What it adds to the map', after: 'The map after this ping',
  },
  notUsed: 'not used',
  rejected: 'rejected',
  tooClose: 'too close',
  silence: 'silence',
  milliseconds: (s: number): string => `${decimals(s * 1000, 2)} ms`,
  halfPath: (speed: number, s: number): string => `½ · ${decimals(speed, 1)} m/s · ${words.milliseconds(s)} = `,
  thereAndBack: (s: number): string => `Sound went there and back in ${words.milliseconds(s)}.`,
  wayOfTwo: (s: number): string => `Sound went out from one sensor and came back to the other in ${words.milliseconds(s)}.`,
  rangeWords: 'Half of that way is the range',
  silentUpTo: (m: number): string => `Nothing answered up to ${metres(m)}; further out silence says nothing.`,
  noRange: 'It has no range.',
  rejectedFor: (name: string): string => `Rejected: ${plain(name)}.`,
  facing: (yawRad: number): string => `Facing ${direction(yawRad)} when it fired`,
  robotAt: (x: number, y: number, yawRad: number): string => `By odometry the robot was at ${place(x, y)} m, heading ${direction(yawRad)}. The sensor sits on it as the description says.`,
  twoSensors: (rx: number, x: number, y: number): string => `Sensor ${rx}, which heard it, was at ${place(x, y)} m.`,
  whatIf: (m: number, yawRad: number): string => `What if: truly it was ${centimetres(m)} and ${degrees(Math.abs(yawRad))} off. Only the picture moves; the map is made with odometry.`,
  metresOf: (x: number, y: number): string => `${place(x, y)} m`,
  arcLong: (m: number): string => `${length(m)} long`,
  somewhere: 'What answered lies somewhere on it',
  fromTo: (from: number, to: number): string => `From ${signedDegrees(from)} to ${signedDegrees(to)} off the beam axis. One echo does not say where on it.`,
  clears: (m: number): string => `up to ${metres(m)}`,
  noArc: 'Nothing answered, so there is no arc. The beam up to there is likely free.',
  cells: (n: number): string => several(n, 'cell', 'cells'),
  stay: (n: number): string => (n === 1 ? `, ${words.cells(n)} stays` : `, ${words.cells(n)} stay`),
  getFuller: (n: number): string => (n === 1 ? ' gets fuller' : ' get fuller'),
  getEmptier: (n: number): string => (n === 1 ? ' gets emptier' : ' get emptier'),
  outlined: 'The outlined one:',
  clickCell: 'Click a cell on the map for its numbers.',
  previousCell: 'Previous cell', nextCell: 'Next cell',
  cellNumber: (n: number, of: number): string => `${count(n)} of ${count(of)}`,
  arcs: (n: number): string => several(n, 'arc', 'arcs'),
  arcsCrossed: 'The arcs it crosses', arcsCut: 'The arcs it cuts', arcsBoth: 'The arcs it crosses and cuts',
  noArcs: 'It crosses and cuts no older arc.',
  columns: ['Ping', 'Sensor', 'Range', 'What happens'],
  happens: (what: 'crossed' | 'cut' | 'removed', note: string): string => (what === 'crossed' ? `crosses ${note}`.trimEnd() : note === '' ? what : note),
  moreArcs: (n: number): string => `and ${several(n, 'arc', 'arcs')} more, all on the map`,
  pointsAt: (points: string): string => `At ${points} m.`,
  points: (n: number): string => `+${several(n, 'point', 'points')}`,
  mapMoved: 'The map now holds this ping. Go on with the next.',
  back: 'Back', next: (part: string): string => `Next: ${part}`, nextPing: 'Next ping',
  nextParts: { sensor: 'the sensor', arc: 'the arc', cone: 'what it clears', cells: 'the cells', arcs: 'the other arcs', adds: 'what it adds', after: 'the map after it' },
};

export const reasonText = (reason: string): string => `${capital(plain(reason)).replace(/\.$/, '')}.`;

/** What a cell held and holds, in the words of its unit; log-odds as the share they stand for. */
export function beforeAfter(before: number, after: number, unit: string): { before: string; after: string } {
  const percent = (p: number): string => `${decimals(100 * p, 0)}%`;
  if (unit === 'log-odds') return { before: `${percent(shareOf(before))} occupied before, `, after: percent(shareOf(after)) };
  if (unit === 'p') return { before: `${percent(before)} occupied before, `, after: percent(after) };
  return { before: `${plainNumber(before)} before, `, after: `${plainNumber(after)}${unit === '' ? '' : ` ${unitWords(unit)}`}` };
}

/** Log-odds written as the share that they stand for. */
const shareOf = (logOdds: number): number => 1 / (1 + Math.exp(-logOdds));
