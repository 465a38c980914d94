/** What a robot's camera tells: 120 by 120 degrees, drawn as a picture. */
import { label, shape, title } from '../panels/drawing.js';

/** @typedef {import('../state/robot/senses.js').Senses} Senses */

const HALF_DEGREES = 60;
const BALL_RADIUS_METRES = 0.042;
const PLAYER_RADIUS_METRES = 0.08;
const DEGREES = 180 / Math.PI;

/**
 * @param {HTMLElement} place
 * @returns {(seen: Senses['seen'], team: string) => void} draws; the team is the robot's own
 */
export function cameraPicture(place) {
  const svg = shape('svg', { viewBox: `${-HALF_DEGREES} ${-HALF_DEGREES} ${2 * HALF_DEGREES} ${2 * HALF_DEGREES}`, role: 'img', class: 'camera' });
  svg.setAttribute('aria-label', 'What the camera of the robot sees, 120 by 120 degrees');
  const grid = [-30, 0, 30].flatMap((at) => [
    shape('line', { class: 'grid-line', x1: at, x2: at, y1: -HALF_DEGREES, y2: HALF_DEGREES }),
    shape('line', { class: 'grid-line', y1: at, y2: at, x1: -HALF_DEGREES, x2: HALF_DEGREES }),
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
    const lines = seen.lines.filter((line) => line.length === 2).map(([from, to]) => shape('line', { class: 'field-line', ...ends(from, to) }));
    content.replaceChildren(...lines, ...seen.things.flatMap((thing) => drawnThing(thing, team)));
  };
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

/** @param {import('../state/robot/senses.js').SeenThing} thing @param {string} team @returns {SVGElement[]} */
function drawnThing(thing, team) {
  const { name, kind, points } = thing;
  if (points.length === 0) {
    return [];
  }
  const [x, y] = at(points[0].polar);
  const hint = `${name}: ${points[0].polar[0]} m, ${points[0].polar[1]}° left, ${points[0].polar[2]}° up`;
  if (kind === 'player') {
    const side = thing.team === team ? 'mate' : 'opponent';
    const head = points.find((each) => each.name === 'head');
    if (!head) {
      return points.map(({ polar }) => shape('circle', { class: `player ${side}`, cx: at(polar)[0], cy: at(polar)[1], r: 1.2 }, title(hint)));
    }
    const [headX, headY] = at(head.polar);
    const limbs = points.filter((each) => each !== head).map((each) => shape('line', { class: `limb ${side}`, ...ends(head.polar, each.polar) }));
    return [...limbs, shape('circle', { class: `player ${side}`, cx: headX, cy: headY, r: size(PLAYER_RADIUS_METRES, head.polar[0]) }, title(hint)), label(name, headX + 2, headY - 2, 'camera-text')];
  }
  if (kind === 'ball') {
    return [shape('circle', { class: 'seen-ball', cx: x, cy: y, r: size(BALL_RADIUS_METRES, points[0].polar[0]) }, title(hint))];
  }
  const mark = kind === 'post' ? shape('path', { class: 'post', d: `M${x} ${y}m-1.4 0l1.4 -1.4l1.4 1.4l-1.4 1.4z` }, title(hint)) : shape('path', { class: 'flag', d: `M${x} ${y}m-1.2 -1.2h2.4v2.4h-2.4z` }, title(hint));
  return [mark, label(name, x + 2, y + 1.2, 'camera-text')];
}

/** @param {number} radius metres @param {number} distance metres @returns {string} degrees, large enough to be seen */
function size(radius, distance) {
  return Math.max(1, Math.atan2(radius, distance) * DEGREES).toFixed(2);
}
