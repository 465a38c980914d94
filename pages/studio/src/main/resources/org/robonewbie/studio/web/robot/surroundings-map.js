/** Map of a robot's surroundings: ground truth, beliefs and drawings. */
import { label, shape, title } from '../panels/drawing.js';
import { headingDegrees } from '../state/kinematics.js';
import { believedPlace, thingsAround } from '../state/robot/robot-facts.js';

/** @typedef {import('../state/robot/robot-watch.js').RobotMoment} RobotMoment */

const REACH_METRES = 7;
const FADING_SECONDS = 5;
const ARROW = 'M0-.42L.3.3L0 .12L-.3.3z';
const COLOUR = /^(#[0-9a-f]{3,8}|[a-z]+)$/i;

/**
 * @param {HTMLElement} place
 * @returns {(moment: RobotMoment) => void}
 */
export function surroundingsMap(place) {
  const svg = shape('svg', {
    viewBox: `${-REACH_METRES} ${-REACH_METRES} ${2 * REACH_METRES} ${2 * REACH_METRES}`,
    role: 'img',
  });
  svg.setAttribute(
    'aria-label',
    'The robot in the middle faces up. Rings: truth. Filled shapes: what the robot believes.',
  );
  const rings = [2, 4, 6].flatMap((radius) => [
    shape('circle', { class: 'ring', r: radius }),
    label(`${radius} m`, 0.08, -radius + 0.36, 'ring-text'),
  ]);
  const content = shape('g');
  svg.append(...rings, shape('path', { class: 'self', d: ARROW }), content);
  place.append(svg);
  return ({ scene, frame, robot, thoughts }) => {
    const truth = thingsAround(scene, frame, robot).map(({ name, kind, position }) => ring(position, kind, name));
    const belief = (thoughts.belief?.things ?? []).map((thing) => {
      const made = dot(
        thing.position,
        thing.name === 'ball' ? 'ball' : 'other',
        `${thing.name}, seen ${thing.ageSeconds.toFixed(1)} s ago`,
      );
      made.setAttribute('opacity', String(Math.max(0.25, 1 - thing.ageSeconds / FADING_SECONDS)));
      return made;
    });
    const self = thoughts.belief?.self;
    const own = self ? [believedSelf(frame.robots[robot].torso, scene.robots[robot].side, self)] : [];
    content.replaceChildren(...truth, ...own, ...belief, ...thoughts.drawings.map(drawn));
  };
}

/** @param {Float32Array} torso @param {string} side @param {number[]} self believed pose */
function believedSelf(torso, side, self) {
  const { position, heading } = believedPlace(torso, side, self);
  const [x, y] = at(position);
  const turn = headingDegrees(torso) - heading;
  return shape(
    'path',
    { class: 'belief-self', d: ARROW, transform: `translate(${x} ${y}) rotate(${turn.toFixed(1)})` },
    title('believed position of the robot'),
  );
}

/**
 * Converts a position relative to the robot to map coordinates, where forward is up.
 *
 * @param {number[]} position
 * @returns {[string, string]}
 */
function at([forward, left]) {
  return [(-left).toFixed(3), (-forward).toFixed(3)];
}

/** @param {number[]} position @param {string} kind @param {string} name */
function ring(position, kind, name) {
  const [cx, cy] = at(position);
  return shape(
    'circle',
    { class: `truth ${kind}`, cx, cy, r: kind === 'ball' ? 0.16 : 0.24 },
    title(`${name} (truth)`),
  );
}

/** @param {number[]} position @param {string} kind @param {string} name */
function dot(position, kind, name) {
  const [cx, cy] = at(position);
  return shape(
    'circle',
    { class: `belief ${kind}`, cx, cy, r: kind === 'ball' ? 0.12 : 0.15 },
    title(`${name} (belief)`),
  );
}

/** @param {import('../state/robot/telemetry.js').Drawing} drawing */
function drawn({ shape: kind, colour, place, to, radius, text }) {
  const [x, y] = at(place);
  const paint = COLOUR.test(colour) ? colour : 'magenta';
  if (kind === 'line') {
    const [x2, y2] = at(to);
    return shape('line', { class: 'drawing', x1: x, y1: y, x2, y2, stroke: paint });
  }
  if (kind === 'circle') {
    return shape('circle', { class: 'drawing', cx: x, cy: y, r: radius, stroke: paint });
  }
  return kind === 'text'
    ? label(text, Number(x), Number(y), 'drawing drawing-text')
    : shape('circle', { class: 'drawing', cx: x, cy: y, r: 0.08, fill: paint });
}
