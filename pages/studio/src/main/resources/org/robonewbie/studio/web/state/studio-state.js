/** Immutable state of the studio. Pure functions: each message results in a new state, which the panels display. */
import { CYCLE_SECONDS } from './cycle.js';
import { playModeText } from './play-mode.js';

/**
 * @typedef {import('../live/state-frame.js').Scene} Scene
 * @typedef {import('../live/state-frame.js').Frame} Frame
 *
 * @typedef {object} StudioState
 * @property {'opening' | 'live' | 'lost'} connection
 * @property {string} refusal why the simulator rejected this page; empty if it did not
 * @property {Scene | undefined} scene
 * @property {Frame | undefined} frame
 * @property {number} movedMilliseconds time of the last change of the cycle, on the page's clock
 * @property {{side: 'left' | 'right', milliseconds: number} | undefined} goal side and time of the last goal
 * @property {Actions} actions
 * @property {boolean} [isRecorded] whether scene and frame come from a recording
 * @property {string} starting what is about to replace the scene; empty for nothing
 *
 * @typedef {{undo: string, redo: string}} Actions the actions to undo and redo, empty for none
 */

/** Time without a new cycle after which a running world is assumed to be waiting for an agent. */
const STANDSTILL_MILLISECONDS = 1500;

const NO_TEAM = 'no team yet';

const EXERCISE_HINT = 'Choose an exercise, then press “Edit beside the robot”.';

/** How long a goal is celebrated. */
const CHEER_MILLISECONDS = 4000;

/** Default agent port. */
const DEFAULT_AGENT_PORT = 3100;
/** Port of a world that only the page's own programs can join. */
const NO_PORT = 0;

/** Selectable speeds; 'fastest' does not wait between cycles. */
export const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 5, 10, 'fastest'];

/** @returns {StudioState} */
export function initialState() {
  return {
    connection: 'opening',
    refusal: '',
    scene: undefined,
    frame: undefined,
    movedMilliseconds: 0,
    goal: undefined,
    actions: { undo: '', redo: '' },
    starting: '',
  };
}

/**
 * @param {StudioState} state
 * @returns {StudioState}
 */
export function withConnection(state) {
  return { ...state, connection: 'live', refusal: '', scene: undefined, frame: undefined };
}

/**
 * @param {StudioState} state
 * @returns {StudioState}
 */
export function withoutConnection(state) {
  return { ...state, connection: state.connection === 'opening' ? 'opening' : 'lost' };
}

/**
 * @param {StudioState} state
 * @param {string} refusal why the simulator rejected this page
 * @returns {StudioState}
 */
export function withRefusal(state, refusal) {
  return { ...state, refusal };
}

/**
 * @param {StudioState} state
 * @param {Scene} scene
 * @returns {StudioState}
 */
export function withScene(state, scene) {
  return { ...state, scene, frame: undefined, starting: '' };
}

/**
 * @param {StudioState} state
 * @param {string} starting what is about to replace the scene; empty for nothing
 * @returns {StudioState}
 */
export function withStarting(state, starting) {
  return { ...state, starting };
}

/**
 * @param {StudioState} state
 * @param {Actions} actions
 * @returns {StudioState}
 */
export function withActions(state, { undo, redo }) {
  return { ...state, actions: { undo, redo } };
}

/**
 * @param {StudioState} state
 * @param {Frame} frame
 * @param {number} now milliseconds on the page's clock
 * @returns {StudioState}
 */
export function withFrame(state, frame, now) {
  const moved = frame.cycle !== state.frame?.cycle || state.frame.paused;
  return {
    ...state,
    frame,
    movedMilliseconds: moved ? now : state.movedMilliseconds,
    goal: lastGoal(state, frame, now),
  };
}

/**
 * @param {StudioState} state
 * @param {Frame} frame
 * @param {number} now
 */
function lastGoal(state, frame, now) {
  const before = state.frame;
  if (before && frame.scoreLeft > before.scoreLeft) {
    return { side: /** @type {const} */ ('left'), milliseconds: now };
  }
  if (before && frame.scoreRight > before.scoreRight) {
    return { side: /** @type {const} */ ('right'), milliseconds: now };
  }
  return state.goal;
}

/**
 * @typedef {object} Message
 * @property {'waiting' | 'trouble'} tone
 * @property {string} title
 * @property {string} text
 */

/**
 * Returns the message to the user if there is nothing to see or nothing is moving.
 *
 * @param {StudioState} state
 * @param {number} now milliseconds on the page's clock
 * @param {boolean} [inExercises] whether the exercises are open next to the field
 * @returns {Message | undefined}
 */
export function message(state, now, inExercises = false) {
  if (state.refusal) {
    return trouble('The simulator rejected this page', state.refusal);
  }
  if (state.connection === 'lost') {
    return trouble('The simulator has ended', 'Restart it; this page reconnects automatically.');
  }
  if (state.connection === 'opening' || !state.scene) {
    return waiting(
      'Looking for the simulator…',
      'If this does not change, restart the simulator and open the address that it prints.',
    );
  }
  if (state.starting) {
    return waiting(state.starting, 'The program is being compiled.');
  }
  if (state.isRecorded) {
    return undefined;
  }
  if (state.scene.robots.length === 0) {
    return waiting('Waiting for a robot…', inExercises ? EXERCISE_HINT : joinHint(state.scene));
  }
  if (state.frame && !state.frame.paused && now - state.movedMilliseconds > STANDSTILL_MILLISECONDS) {
    return waiting(
      'The world is waiting for an agent',
      'Is it stopped at a breakpoint? The world continues when the agent does.',
    );
  }
  return undefined;
}

/** @param {Scene} scene */
function joinHint({ clock: hasClock, agentPort = DEFAULT_AGENT_PORT }) {
  if (agentPort === NO_PORT) {
    return 'Choose an agent in the toolbar above, or run a program in the Program room.';
  }
  const port = agentPort === DEFAULT_AGENT_PORT ? '' : ` --port ${agentPort}`;
  return hasClock === false
    ? 'Run an agent that joins the watched server.'
    : `Add a puppet, or run an agent: ./robonewbie run Agent_BasicStructure${port}`;
}

/**
 * @param {string} title
 * @param {string} text
 * @returns {Message}
 */
function trouble(title, text) {
  return { tone: 'trouble', title, text };
}

/**
 * @param {string} title
 * @param {string} text
 * @returns {Message}
 */
function waiting(title, text) {
  return { tone: 'waiting', title, text };
}

/**
 * Returns the content of the scoreboard.
 *
 * @param {StudioState} state
 * @param {number} now milliseconds on the page's clock
 */
export function scoreBoard(state, now) {
  const { scene, frame, goal } = state;
  return {
    isGame: isGame(state),
    cheers: goal && now - goal.milliseconds < CHEER_MILLISECONDS ? goal.side : '',
    left: scene?.teams.left || NO_TEAM,
    right: scene?.teams.right || NO_TEAM,
    hasLeft: Boolean(scene?.teams.left),
    hasRight: Boolean(scene?.teams.right),
    score: frame ? `${frame.scoreLeft} : ${frame.scoreRight}` : '– : –',
    clock: frame ? clock(frame.gameTime) : '--:--',
    half: frame ? (frame.half === 2 ? '2nd half' : '1st half') : '',
    playMode: scene && frame ? playModeText(scene.playModes[frame.playMode], scene.teams) : '',
  };
}

/** Returns whether there are two teams or there has been a goal. @param {StudioState} state */
function isGame({ scene, frame }) {
  const hasBoth = Boolean(scene?.teams.left && scene.teams.right);
  return hasBoth || (frame !== undefined && frame.scoreLeft + frame.scoreRight > 0);
}

/**
 * Returns the state of the time controls.
 *
 * @param {StudioState} state
 */
export function transport(state) {
  const { frame } = state;
  return {
    enabled: state.connection === 'live' && frame !== undefined && state.scene?.clock !== false,
    paused: frame?.paused ?? false,
    speed: frame && nearestSpeed(frame.speed),
    seconds: frame ? `${(frame.cycle * CYCLE_SECONDS).toFixed(2)} s` : '',
    cycle: frame ? `cycle ${frame.cycle}` : '',
    realTimeFactor: frame ? factorText(frame) : '',
  };
}

/**
 * Returns the selectable speed nearest to the requested one.
 *
 * @param {number} speed
 * @returns {number | string}
 */
export function nearestSpeed(speed) {
  const numbers = /** @type {number[]} */ (SPEEDS.filter((each) => typeof each === 'number'));
  if (speed > 10 * numbers[numbers.length - 1]) {
    return 'fastest';
  }
  return numbers.reduce((best, each) => (Math.abs(each - speed) < Math.abs(best - speed) ? each : best));
}

/**
 * Returns the next faster or slower speed.
 *
 * @param {number} speed the requested speed
 * @param {1 | -1} direction
 */
export function neighbourSpeed(speed, direction) {
  const index = SPEEDS.indexOf(nearestSpeed(speed)) + direction;
  return SPEEDS[Math.max(0, Math.min(SPEEDS.length - 1, index))];
}

/** @param {Frame} frame */
function factorText(frame) {
  if (frame.paused) {
    return 'paused';
  }
  const factor = frame.realTimeFactor;
  return `${factor < 9.95 ? factor.toFixed(1) : factor.toFixed(0)}× real time`;
}

/**
 * Formats a game time.
 *
 * @param {number} seconds
 */
export function clock(seconds) {
  const whole = Math.floor(seconds + 1e-3);
  return `${String(Math.floor(whole / 60)).padStart(2, '0')}:${String(whole % 60).padStart(2, '0')}`;
}
