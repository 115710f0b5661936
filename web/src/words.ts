// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Every sentence the page says. */
import { capital, clock, size, whole, words as plain } from './ui/format.ts';

export const words = {
  stop: 'Stop', stopped: 'Stopped', byYou: 'by you', cannotReach: 'cannot reach it', space: 'Space',
  live: 'Live', playing: 'Playing', paused: 'Paused', held: 'Held', backToLive: 'Back to live', connecting: 'Connecting', reconnecting: 'Reconnecting',
  saveMap: 'Save map', drive: 'Drive', handOver: 'Hand over', keep: 'Keep', askToDrive: 'Ask to drive',
  youDrive: 'You are driving', tryNow: 'Try now', reload: 'Reload', reconnect: 'Reconnect', driveAgain: 'Drive again',
  hint: 'Click a point to see the pings behind it', hideHint: 'Hide this hint',
  back: 'Methods and layers', addMethod: '+ Add method', nobody: 'Nobody, the robot stands',
  noScore: 'No truth or laser in this source, so no score.', scoresLater: 'Scores appear with the first points.',
  apply: 'Apply', leaveAsIs: 'Leave as it is', outliers: 'Outliers: Numakura’s four maps', withDefault: 'Compare with default', another: 'runs already; once more',
  noPoints: 'no points yet', notHere: 'not in this source', linkCopied: 'Link copied', updated: 'The server was updated.',
  tokenDialog: 'Open the drive link printed where echoarc was started, or paste its token.',
  tokenWrong: 'That token is not valid here. The right one is in the link printed at start.',
  slow: 'This page could not keep up and was disconnected. The robot is not affected.',
  noWebGl: 'Drawing without graphics acceleration; large maps may be slow.',
  nothingNear: 'Nothing within 8 px. Cells can be clicked from zoom 90.',
  goneSince: 'That point is no longer on the live map, which is the one that is explained.',
  stillLostTitle: 'Still no connection',
  stillLost: 'echoarc may have ended. Its log is saved; `echoarc serve --resume DIR` continues the same map.',
  noneDroppedSilently: 'Nothing is dropped silently. This is where they went:',
  noPings: 'No pings yet', playsLog: 'Playing a log', logPaused: 'The log is paused', onlyDriver: 'Only the driver changes options.', mapSwitches: 'The map switches when it is done.',
  occupiedIn: 'Occupied in', inBoth: 'both', onlyIn: (method: string): string => `${method} alone`,
  dropBody: 'It maps with the methods you have chosen. The running robot keeps its own log.',
  asksToDrive: (name: string): string => `${name} asks to drive`,
  lostTitle: (s: number): string => `Connection lost ${Math.round(s)} s ago`,
  lostBody: (t: number, who: string, retryS: number): string =>
    `The view is held at ${clock(t)}. ${who} ${retryS > 0 ? `Trying again in ${Math.ceil(retryS)} s.` : 'Trying again now.'}`,
  backAgain: (pings: number): string => `Connected again. ${whole(pings)} pings came in between; all are on the map.`,
  lostDriving: 'You no longer drive: nothing reached the robot for 0.5 s, so it stopped.',
  noneOnMap: (pings: number): string => `${whole(pings)} pings came, none made it onto the map`,
  dropTitle: (name: string): string => `Drop to open ${name}`,
  unknownFile: (name: string): string => `echoarc cannot read ${name}. It reads JSON Lines, CARMEN logs and CSV with a description.`,
  tooLarge: (bytes: number, limit: number): string =>
    `${size(bytes)} is more than this server takes (${size(limit)}). Start \`echoarc serve --log FILE\` instead.`,
  obstacle: (cm: number): string => `Stopped: obstacle ${whole(cm)} cm ahead. Drive back, or turn.`,
  obstacleAhead: (cm: number): string => `Obstacle ${whole(cm)} cm ahead`,
  outOfRange: (title: string, from: string, to: string): string => `${title} must be from ${from} to ${to}.`,
  linkOptions: (methods: readonly string[]): string => `This link has other options of ${methods.join(', ')}. Apply these options?`,
  saved: (name: string, bytes: number): string => `Saved ${name}, ${size(bytes)}`,
};

const modeWords: Record<string, string> = {
  stand: 'Standing', tour: 'Touring by itself', drive: 'Driven', goto: 'Going to a point', home: 'Returning home', frontier: 'Exploring frontiers',
  gvg: 'Exploring the Voronoi graph', 'wall-left': 'Following the left wall', 'wall-right': 'Following the right wall',
};
const modeActions: Record<string, string> = {
  frontier: 'Explore frontiers', gvg: 'Explore Voronoi graph', 'wall-left': 'Follow left wall', 'wall-right': 'Follow right wall',
  goto: 'Go to point', home: 'Return home', tour: 'Tour', stand: 'Stand',
};
export const modeNow = (mode: string): string => modeWords[mode] ?? capital(plain(mode));
export const modeAction = (mode: string): string => modeActions[mode] ?? capital(plain(mode));

/** As the menu lists them; a mode that is started otherwise, by driving, is not among them. */
export function menuModes(modes: readonly string[]): string[] {
  const order = Object.keys(modeActions);
  const known = order.filter((mode) => modes.includes(mode));
  return [...known, ...modes.filter((mode) => mode !== 'drive' && !order.includes(mode))];
}
/** How a strategy ended by itself. */
export function modeEnded(mode: string, reached: boolean, detail: string): string {
  return `${modeAction(mode)}: ${reached ? 'done' : 'given up'}${detail === '' ? '' : `, ${detail}`}`;
}

/** Who moved the robot when the connection broke, and what that means now. */
export function whoDrove(mode: string, driver: string | null, iDrove: boolean): string {
  if (iDrove) return 'You were driving; the robot stops by itself half a second after its driver is gone.';
  if (driver !== null) return `${driver} was driving and may still be.`;
  if (mode === 'stand' || mode === '') return 'It was standing still.';
  const was = modeNow(mode);
  return `It was ${was.charAt(0).toLowerCase()}${was.slice(1)} and may go on; its obstacle stop does not need this page.`;
}
