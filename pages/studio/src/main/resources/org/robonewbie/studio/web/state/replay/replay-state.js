/**
 * Playback state of a replay. Pure.
 *
 * @typedef {import('./recording-reader.js').Moment} Moment
 * @typedef {import('./recording-reader.js').RecordedEvent} RecordedEvent
 * @typedef {import('../../live/state-frame.js').Scene} Scene
 * @typedef {import('../../live/state-frame.js').Frame} Frame
 * @typedef {import('../kinematics.js').RobotModel} RobotModel
 *
 * @typedef {object} ReplayState
 * @property {number} count number of moments
 * @property {number} index index of the displayed moment; fractional between two moments
 * @property {boolean} playing
 * @property {number} speed
 * @property {[number, number] | undefined} loop first and last moment of the repeated section
 */

import { BALL_RADIUS } from '../ball-radius.js';
import { POSE_NUMBERS, STEPS_PER_METRE } from './recording-source.js';

const STEPS_PER_TURN = 20_000;
const STEPS_PER_DEGREE = 100;
export const MOMENTS_PER_SECOND = 50;

/** @type {ReplayState} */
export const BEGINNING = { count: 0, index: 0, playing: false, speed: 1, loop: undefined };

/** @param {ReplayState} state @param {number} index @returns {ReplayState} */
export function atMoment(state, index) {
  return { ...state, index: Math.max(0, Math.min(state.count - 1, index)) };
}

/** @param {ReplayState} state @param {number} by number of moments @returns {ReplayState} */
export function stepped(state, by) {
  return { ...atMoment(state, Math.round(state.index) + by), playing: false };
}

/**
 * @param {ReplayState} state
 * @param {number} seconds elapsed seconds
 * @returns {ReplayState}
 */
export function advanced(state, seconds) {
  if (!state.playing) {
    return state;
  }
  const [first, last] = state.loop ?? [0, state.count - 1];
  const index = state.index + seconds * state.speed * MOMENTS_PER_SECOND;
  if (index < last) {
    return atMoment(state, index);
  }
  return state.loop ? atMoment(state, first) : { ...atMoment(state, last), playing: false };
}

/**
 * Toggles the repetition of the two seconds before and after the current moment.
 *
 * @param {ReplayState} state
 * @returns {ReplayState}
 */
export function looped(state) {
  if (state.count === 0) {
    return state;
  }
  const reach = 2 * MOMENTS_PER_SECOND;
  const range = /** @type {[number, number]} */ ([
    Math.max(0, state.index - reach),
    Math.min(state.count - 1, state.index + reach),
  ]);
  return { ...state, loop: state.loop ? undefined : range };
}

/**
 * @param {ReplayState} state
 * @param {readonly RecordedEvent[]} events
 * @param {-1 | 1} direction
 * @returns {RecordedEvent | undefined} the next event in the given direction
 */
export function neighbourEvent(state, events, direction) {
  const sorted = [...events].sort((a, b) => a.index - b.index);
  return direction > 0
    ? sorted.find(({ index }) => index > state.index + 1)
    : sorted.findLast(({ index }) => index < state.index - 1);
}

/**
 * @param {Moment} moment
 * @param {Record<string, string>} header header of the recording
 * @param {Record<string, RobotModel>} models
 * @param {number} revision
 * @returns {Scene} scene of the moment
 */
export function sceneOf(moment, header, models, revision) {
  const number = (/** @type {string} */ name, /** @type {number} */ otherwise) => Number(header[name] ?? otherwise);
  return {
    revision,
    field: {
      length: number('FieldLength', 12),
      width: number('FieldWidth', 8),
      goalWidth: number('GoalWidth', 2.1),
      goalDepth: number('GoalDepth', 0.6),
      goalHeight: number('GoalHeight', 0.8),
      penaltyLength: number('PenaltyLength', 1.8),
      penaltyWidth: number('PenaltyWidth', 3.9),
      centreCircleRadius: number('FreeKickDistance', 2),
    },
    teams: { left: moment.game.left, right: moment.game.right },
    robots: moment.robots,
    things: (moment.things ?? []).map(({ thing }) => thing),
    models: moment.models ? { ...models, ...moment.models } : models,
    playModes: [moment.game.playMode],
    details: {
      ballRadius: number('BallRadius', BALL_RADIUS),
      goalAreaLength: number('GoalAreaLength', 0),
      goalAreaWidth: number('GoalAreaWidth', 0),
      penaltySpotDistance: number('PenaltySpotDistance', 0),
    },
  };
}

/**
 * @param {Moment} moment
 * @param {Scene} scene scene of the moment
 * @returns {Frame} frame to draw
 */
export function frameOf(moment, scene) {
  const { numbers, game } = moment;
  let at = POSE_NUMBERS;
  const robots = moment.robots.map(({ type }) => {
    const hinges = scene.models[type].hinges.length;
    const robot = {
      torso: poseAt(numbers, at),
      degrees: Float32Array.from(
        numbers.subarray(at + POSE_NUMBERS, at + POSE_NUMBERS + hinges),
        (steps) => steps / STEPS_PER_DEGREE,
      ),
    };
    at += POSE_NUMBERS + hinges;
    return robot;
  });
  return {
    paused: false,
    sceneRevision: scene.revision,
    cycle: moment.cycle,
    gameTime: moment.gameTime,
    speed: 1,
    realTimeFactor: 1,
    playMode: 0,
    scoreLeft: game.scoreLeft,
    scoreRight: game.scoreRight,
    half: game.half,
    ball: poseAt(numbers, 0),
    robots,
    things: (moment.things ?? []).map(({ pose }) => poseAt(pose, 0)),
  };
}

/** @param {Int32Array} numbers @param {number} at */
function poseAt(numbers, at) {
  const pose = new Float32Array(POSE_NUMBERS);
  for (let i = 0; i < 3; i++) {
    pose[i] = numbers[at + i] / STEPS_PER_METRE;
  }
  const length = Math.hypot(...numbers.subarray(at + 3, at + POSE_NUMBERS)) || STEPS_PER_TURN;
  for (let i = 3; i < POSE_NUMBERS; i++) {
    pose[i] = numbers[at + i] / length;
  }
  return pose;
}

/**
 * Repeats the moments of a thinned-out recording to restore fifty per second.
 *
 * @param {readonly Moment[]} moments
 * @param {readonly RecordedEvent[]} events
 * @returns {{moments: Moment[], events: RecordedEvent[]}}
 */
export function evenly(moments, events) {
  const first = moments[0]?.cycle ?? 0;
  const place = (/** @type {number} */ index) => (moments[index] ?? moments.at(-1)).cycle - first;
  return {
    moments: moments.flatMap((moment, i) =>
      Array(Math.max(1, (moments[i + 1]?.cycle ?? 0) - moment.cycle)).fill(moment),
    ),
    events: events.map((event) => ({ ...event, index: place(event.index) })),
  };
}

/**
 * @param {string} place address fragment of a recording
 * @returns {{name: string, seconds: number | undefined, plays: boolean}} name of the recording, the moment if one is given, and whether to
 *     play it immediately
 */
export function placeOf(place) {
  const text = decodeURIComponent(place.split('/').slice(1).join('/'));
  const moment = text.match(/^(.*)@(play|\d+(?:\.\d+)?)$/s);
  if (!moment) {
    return { name: text, seconds: undefined, plays: false };
  }
  const plays = moment[2] === 'play';
  return { name: moment[1], seconds: plays ? undefined : Number(moment[2]), plays };
}
