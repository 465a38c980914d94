/** Traces of one recorded robot around one moment. Pure. */
import { frameOf, sceneOf } from '../replay/replay-state.js';
import { jointValues, trueValues } from './signals.js';
import { Traces } from './traces.js';

/**
 * @typedef {import('../replay/recording-reader.js').Moment} Moment
 * @typedef {import('../../live/state-frame.js').Scene} Scene
 */

/**
 * @param {readonly Moment[]} moments
 * @param {Record<string, string>} header header of the recording
 * @param {Scene} scene
 * @param {number} id ID of the robot
 * @returns {Traces} traces of these moments
 */
export function recordedTraces(moments, header, scene, id) {
  const traces = new Traces();
  for (const moment of moments) {
    const robot = moment.robots.findIndex((each) => each.id === id);
    if (robot >= 0) {
      const model = scene.models[moment.robots[robot].type];
      const now = sceneOf(moment, header, scene.models, 0);
      traces.add(moment.cycle, trueValues(model, frameOf(moment, now), robot));
      traces.add(moment.cycle, jointValues(model, 'commanded speed', moment.speeds.get(id) ?? []));
    }
  }
  return traces;
}
