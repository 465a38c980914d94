/**
 * Other objects on the pitch in a recording; poses are in the file's units. Pure.
 *
 * @typedef {import('../../live/state-frame.js').Thing} Thing
 * @typedef {import('./recording-source.js').Source} Source
 *
 * @typedef {object} RecordedThing
 * @property {Thing} thing
 * @property {number} grams
 * @property {Int32Array} pose
 */

import { POSE_NUMBERS, STEPS_PER_METRE } from './recording-source.js';

/** @param {Source} content content of a record of kind 8 @returns {RecordedThing[]} */
export function readThings(content) {
  return Array.from({ length: content.unsigned() }, () => {
    const name = content.text();
    const metres = () => content.unsigned() / STEPS_PER_METRE;
    const size = /** @type {[number, number, number]} */ ([metres(), metres(), metres()]);
    const grams = content.unsigned();
    return { thing: { name, size, movable: grams > 0 }, grams, pose: readPose(content) };
  });
}

/** @param {readonly RecordedThing[]} things @param {Source} content content of a record of kind 9 @returns {RecordedThing[]} */
export function withMoved(things, content) {
  const index = content.unsigned();
  const pose = readPose(content);
  return things.map((each, i) => (i === index ? { ...each, pose } : each));
}

/** @param {RecordedThing} thing @returns {number[]} the unsigned numbers that follow its name */
export function measuresOf({ thing, grams }) {
  return [...thing.size.map((metres) => Math.round(metres * STEPS_PER_METRE)), grams];
}

/** @param {Source} content */
function readPose(content) {
  return Int32Array.from({ length: POSE_NUMBERS }, () => content.signed());
}
