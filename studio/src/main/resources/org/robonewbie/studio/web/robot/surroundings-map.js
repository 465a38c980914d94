/** The surroundings of a robot from above: what is true, what it believes, and what it draws. */
import { thingsAround } from '../state/robot/robot-facts.js';

/**
 * @typedef {import('../live/state-frame.js').Scene} Scene
 * @typedef {import('../live/state-frame.js').Frame} Frame
 * @typedef {import('../state/robot/telemetry.js').Thoughts} Thoughts
 */

const SVG = 'http://www.w3.org/2000/svg';
const REACH_METRES = 7;
const PICTURE_SECONDS = 1;
const COLOUR = /^(#[0-9a-f]{3,8}|[a-z]+)$/i;

/**
 * @param {HTMLElement} place
 * @returns {(scene: Scene, frame: Frame, robot: number, thoughts: Thoughts) => void}
 */
export function surroundingsMap(place) {
  const svg = node('svg', { viewBox: `${-REACH_METRES} ${-REACH_METRES} ${2 * REACH_METRES} ${2 * REACH_METRES}`, role: 'img' });
  svg.setAttribute('aria-label', 'The robot in the middle looks up. Rings: truth. Filled: what the robot believes.');
  const rings = [2, 4, 6].flatMap((radius) => [
    node('circle', { class: 'ring', r: String(radius) }),
    label(`${radius} m`, 0.08, -radius + 0.36, 'ring-text'),
  ]);
  const content = node('g', {});
  svg.append(...rings, node('path', { class: 'self', d: 'M0-.42L.3.3L0 .12L-.3.3z' }), content);
  place.append(svg);
  return (scene, frame, robot, thoughts) => {
    const truth = thingsAround(scene, frame, robot).map(({ name, kind, position }) => ring(position, kind, name));
    const belief = (thoughts.belief?.things ?? []).flatMap((thing) => {
      const made = dot(thing.position, thing.name === 'ball' ? 'ball' : 'other', `${thing.name}, seen ${thing.ageSeconds.toFixed(1)} s ago`);
      made.setAttribute('opacity', String(Math.max(0.25, 1 - thing.ageSeconds / 5)));
      return [made];
    });
    const isFresh = frame.gameTime - thoughts.picture.seconds < PICTURE_SECONDS || thoughts.picture.drawings.length > 0;
    const drawings = isFresh ? thoughts.picture.drawings.map(drawn) : [];
    content.replaceChildren(...truth, ...belief, ...drawings);
  };
}

/** Forward is up, left is left. @param {number[]} position @returns {[string, string]} */
function at([forward, left]) {
  return [(-left).toFixed(3), (-forward).toFixed(3)];
}

/** @param {number[]} position @param {string} kind @param {string} name */
function ring(position, kind, name) {
  const [cx, cy] = at(position);
  const made = node('circle', { class: `truth ${kind}`, cx, cy, r: kind === 'ball' ? '0.16' : '0.24' });
  made.append(title(`${name} (truth)`));
  return made;
}

/** @param {number[]} position @param {string} kind @param {string} name */
function dot(position, kind, name) {
  const [cx, cy] = at(position);
  const made = node('circle', { class: `belief ${kind}`, cx, cy, r: kind === 'ball' ? '0.12' : '0.15' });
  made.append(title(`${name} (belief)`));
  return made;
}

/** @param {import('../state/robot/telemetry.js').Drawing} drawing */
function drawn({ shape, colour, place, to, radius, text }) {
  const [x, y] = at(place);
  const paint = COLOUR.test(colour) ? colour : 'magenta';
  if (shape === 'line') {
    const [x2, y2] = at(to);
    return node('line', { class: 'drawing', x1: x, y1: y, x2, y2, stroke: paint });
  }
  if (shape === 'circle') {
    return node('circle', { class: 'drawing', cx: x, cy: y, r: String(radius), stroke: paint });
  }
  return shape === 'text' ? label(text, Number(x), Number(y), 'drawing-text') : node('circle', { cx: x, cy: y, r: '0.08', fill: paint });
}

/** @param {string} name @param {Record<string, string>} attributes */
function node(name, attributes) {
  const made = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) {
    made.setAttribute(key, value);
  }
  return made;
}

/** @param {string} content @param {number} x @param {number} y @param {string} kind */
function label(content, x, y, kind) {
  const made = node('text', { x: String(x), y: String(y), class: kind });
  made.textContent = content;
  return made;
}

/** @param {string} content */
function title(content) {
  const made = node('title', {});
  made.textContent = content;
  return made;
}
