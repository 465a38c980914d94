/** The output of a robot's camera, 120 by 120 degrees, drawn as a picture. */
import { label, shape, title } from '../panels/drawing.js';
import { BALL_RADIUS } from '../state/ball-radius.js';

/**
 * @typedef {import('../state/robot/senses.js').Senses} Senses
 * @typedef {import('../state/robot/senses.js').SeenThing} SeenThing
 */

const HALF_DEGREES = 60;
const PLAYER_RADIUS_METRES = 0.08;
const MIN_PLAYER_DEGREES = 1.2;
const DEGREES = 180 / Math.PI;
const POST = 'm-1.4 0l1.4 -1.4l1.4 1.4l-1.4 1.4z';
const FLAG = 'm-1.2 -1.2h2.4v2.4h-2.4z';

/**
 * @param {HTMLElement} place
 * @returns {(seen: Senses['seen'], team: string) => void} function that updates the picture; `team` is the robot's own team
 */
export function cameraPicture(place) {
  const svg = shape('svg', {
    viewBox: `${-HALF_DEGREES} ${-HALF_DEGREES} ${2 * HALF_DEGREES} ${2 * HALF_DEGREES}`,
    role: 'img',
    class: 'camera',
  });
  svg.setAttribute('aria-label', 'What the robot’s camera sees, 120 by 120 degrees');
  const grid = [-30, 0, 30].flatMap((degrees) => [
    shape('line', { class: 'grid-line', x1: degrees, x2: degrees, y1: -HALF_DEGREES, y2: HALF_DEGREES }),
    shape('line', { class: 'grid-line', y1: degrees, y2: degrees, x1: -HALF_DEGREES, x2: HALF_DEGREES }),
  ]);
  const content = shape('g');
  svg.append(...grid, content);
  place.append(svg);
  let drawn = '';
  return (seen, team) => {
    const key = JSON.stringify(seen ?? '');
    if (key === drawn) {
      return;
    }
    drawn = key;
    if (!seen) {
      content.replaceChildren(label('no picture', -17, 2, 'camera-text'));
      return;
    }
    const lines = seen.lines
      .filter((line) => line.length === 2)
      .map(([from, to]) => shape('line', { class: 'field-line', ...ends(from, to) }));
    content.replaceChildren(...lines, ...nearestFirst(seen.things).flatMap((thing) => drawnThing(thing, team)));
    hideCoveredNames([...content.querySelectorAll('text')]);
  };
}

/** @param {readonly SeenThing[]} things */
function nearestFirst(things) {
  const distance = (/** @type {SeenThing} */ { points }) => points[0]?.polar[0] ?? Infinity;
  return [...things].sort((a, b) => distance(a) - distance(b));
}

/** Hides labels that would overlap; earlier labels take precedence. @param {SVGTextElement[]} names */
function hideCoveredNames(names) {
  /** @type {DOMRect[]} */
  const taken = [];
  for (const name of names) {
    const box = name.getBBox();
    const isCovered = taken.some(
      ({ x, y, width, height }) =>
        box.x < x + width && x < box.x + box.width && box.y < y + height && y < box.y + box.height,
    );
    name.toggleAttribute('hidden', isCovered);
    if (!isCovered) {
      taken.push(box);
    }
  }
}

/** @param {number[]} polar distance, degrees left, degrees up @returns {[number, number]} */
function at([, left, up]) {
  return [-left, -up];
}

/** @param {number[]} from @param {number[]} to */
function ends(from, to) {
  const [x1, y1] = at(from);
  const [x2, y2] = at(to);
  return { x1, y1, x2, y2 };
}

/** @param {SeenThing} thing @param {string} team @returns {SVGElement[]} */
function drawnThing(thing, team) {
  const { name, kind, points } = thing;
  if (points.length === 0) {
    return [];
  }
  const [distance, left, up] = points[0].polar;
  const hint = title(`${name}: ${distance} m, ${left}° left, ${up}° up`);
  if (kind === 'player') {
    return drawnPlayer(thing, team, hint);
  }
  const [cx, cy] = at(points[0].polar);
  if (kind === 'ball') {
    return [shape('circle', { class: 'seen-ball', cx, cy, r: size(BALL_RADIUS, distance) }, hint)];
  }
  const [look, outline] = kind === 'post' ? ['post', POST] : ['flag', FLAG];
  const mark = shape('path', { class: look, d: `M${cx} ${cy}${outline}` }, hint);
  return [mark, label(name, cx + 2, cy + 1.2, 'camera-text')];
}

/** @param {SeenThing} thing @param {string} team @param {SVGElement} hint @returns {SVGElement[]} */
function drawnPlayer({ name, points, team: shirt }, team, hint) {
  const side = shirt === team ? 'mate' : 'opponent';
  const dot = (/** @type {number[]} */ polar, /** @type {string | number} */ r) => {
    const [cx, cy] = at(polar);
    return shape('circle', { class: `player ${side}`, cx, cy, r }, hint.cloneNode(true));
  };
  const head = points.find((each) => each.name === 'head')?.polar;
  if (!head) {
    return points.map(({ polar }) => dot(polar, MIN_PLAYER_DEGREES));
  }
  const limbs = points
    .filter(({ polar }) => polar !== head)
    .map(({ polar }) => shape('line', { class: `limb ${side}`, ...ends(head, polar) }));
  const [x, y] = at(head);
  return [...limbs, dot(head, size(PLAYER_RADIUS_METRES, head[0])), label(name, x + 2, y - 2, 'camera-text')];
}

/** @param {number} radius metres @param {number} distance metres @returns {string} degrees, large enough to be visible */
function size(radius, distance) {
  return Math.max(1, Math.atan2(radius, distance) * DEGREES).toFixed(2);
}
