/** The values of one robot of a recording, around one moment. Pure. */
import { frameOf, sceneOf } from '../replay/replay-state.js';
import { commandedValues, trueValues } from './signals.js';
import { Traces } from './traces.js';

/**
 * @typedef {import('../replay/recording-reader.js').RecordingReader} RecordingReader
 * @typedef {import('../../live/state-frame.js').Scene} Scene
 */

const REACH = 3000;

/**
 * @param {RecordingReader} reader
 * @param {Scene} scene
 * @param {number} id of the robot
 * @param {number} cycle in the middle
 * @returns {Traces} of one minute before and after
 */
export function recordedTraces(reader, scene, id, cycle) {
  const traces = new Traces();
  const { moments } = reader;
  const middle = cycle - (moments[0]?.cycle ?? 0);
  for (const moment of moments.slice(Math.max(0, middle - REACH), middle + REACH)) {
    const robot = moment.robots.findIndex((each) => each.id === id);
    if (robot >= 0) {
      const model = scene.models[moment.robots[robot].type];
      const now = sceneOf(moment, reader.header, scene.models, 0);
      traces.add(moment.cycle, trueValues(model, frameOf(moment, now), robot));
      traces.add(moment.cycle, commandedValues(model, moment.speeds.get(id) ?? []));
    }
  }
  return traces;
}
