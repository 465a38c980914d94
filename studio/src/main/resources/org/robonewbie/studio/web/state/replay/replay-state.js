/**
 * Where the replay is and what it shows. Pure.
 *
 * @typedef {import('./recording-reader.js').Moment} Moment
 * @typedef {import('./recording-reader.js').RecordedEvent} RecordedEvent
 * @typedef {import('../../live/state-frame.js').Scene} Scene
 * @typedef {import('../../live/state-frame.js').Frame} Frame
 * @typedef {import('../kinematics.js').RobotModel} RobotModel
 *
 * @typedef {object} ReplayState
 * @property {number} count how many moments there are
 * @property {number} index the moment that is shown, with a fraction between two
 * @property {boolean} playing
 * @property {number} speed
 * @property {[number, number] | undefined} loop first and last moment that are repeated
 */

const STEPS_PER_METRE = 10_000;
const STEPS_PER_TURN = 20_000;
const STEPS_PER_DEGREE = 100;
const POSE_NUMBERS = 7;
export const MOMENTS_PER_SECOND = 50;

/** @type {ReplayState} */
export const BEGINNING = { count: 0, index: 0, playing: false, speed: 1, loop: undefined };

/** @param {ReplayState} state @param {number} index @returns {ReplayState} */
export function atMoment(state, index) {
  return { ...state, index: Math.max(0, Math.min(state.count - 1, index)) };
}

/** @param {ReplayState} state @param {number} by moments @returns {ReplayState} */
export function stepped(state, by) {
  return { ...atMoment(state, Math.round(state.index) + by), playing: false };
}

/**
 * @param {ReplayState} state
 * @param {number} seconds that have passed
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
 * Repeats the two seconds before and after the moment, or nothing any more.
 *
 * @param {ReplayState} state
 * @returns {ReplayState}
 */
export function looped(state) {
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
 * @returns {RecordedEvent | undefined} the next event in this direction
 */
export function neighbourEvent(state, events, direction) {
  const sorted = [...events].sort((a, b) => a.index - b.index);
  return direction > 0
    ? sorted.find(({ index }) => index > state.index + 1)
    : sorted.findLast(({ index }) => index < state.index - 1);
}

/**
 * @param {Moment} moment
 * @param {Record<string, string>} header of the recording
 * @param {Record<string, RobotModel>} models
 * @param {number} revision
 * @returns {Scene} who plays
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
    models,
    playModes: [moment.game.playMode],
  };
}

/**
 * @param {Moment} moment
 * @param {Scene} scene the one of the moment
 * @returns {Frame} what the picture shows
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
 * Writes a recording as a table: one line for each cycle in which those robots were there that were there the longest.
 *
 * @param {readonly Moment[]} moments
 * @param {Record<string, RobotModel>} models
 * @returns {string}
 */
export function csvOf(moments, models) {
  /** @type {Map<Moment['robots'], number>} */
  const rosters = new Map();
  moments.forEach(({ robots }) => rosters.set(robots, (rosters.get(robots) ?? 0) + 1));
  const robots = [...rosters.keys()].reduce(
    (best, each) => ((rosters.get(each) ?? 0) > (rosters.get(best) ?? 0) ? each : best),
    moments[0]?.robots ?? [],
  );
  const head = ['cycle', 'game_time_s', 'play_mode', 'score_left', 'score_right', 'ball_x_m', 'ball_y_m', 'ball_z_m'];
  for (const { team, number, type } of robots) {
    const name = `${team}_${number}`.replaceAll(/[^\p{L}\p{N}]+/gu, '_');
    head.push(...['x_m', 'y_m', 'z_m'].map((axis) => `${name}_${axis}`));
    head.push(...models[type].hinges.map(({ joint }) => `${name}_${joint.toLowerCase()}_deg`));
  }
  const rows = moments
    .filter((moment) => moment.robots === robots)
    .map((moment) => rowOf(moment, sceneOf(moment, {}, models, 0)));
  return [head.join(','), ...rows, ''].join('\n');
}

/** @param {Moment} moment @param {Scene} scene */
function rowOf(moment, scene) {
  const { ball, robots } = frameOf(moment, scene);
  const place = (/** @type {Float32Array} */ pose) => [0, 1, 2].map((i) => pose[i].toFixed(4));
  const { game } = moment;
  return [
    moment.cycle,
    moment.gameTime.toFixed(2),
    game.playMode,
    game.scoreLeft,
    game.scoreRight,
    ...place(ball),
    ...robots.flatMap(({ torso, degrees }) => [...place(torso), ...Array.from(degrees, (angle) => angle.toFixed(2))]),
  ].join(',');
}
