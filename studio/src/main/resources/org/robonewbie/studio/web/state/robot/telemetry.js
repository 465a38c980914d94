/**
 * What robots tell about their thoughts: reads the lines that the server hands on, as the Java class TelemetryLine writes
 * them, and keeps the newest of each robot. Pure.
 *
 * @typedef {object} LogLine
 * @property {number} seconds
 * @property {string} level
 * @property {string} text
 *
 * @typedef {object} BelievedThing
 * @property {string} name
 * @property {number[]} position metres from the head along the torso's axes: forward, left, up
 * @property {number} ageSeconds
 * @property {boolean} visible
 *
 * @typedef {object} Drawing
 * @property {string} shape point, line, circle or text
 * @property {string} colour
 * @property {number[]} place
 * @property {number[]} to second point of a line
 * @property {number} radius
 * @property {string} text
 *
 * @typedef {object} Thoughts
 * @property {readonly LogLine[]} log the newest last
 * @property {{name: string, keyframe: number}} motion
 * @property {{things: BelievedThing[], self: number[] | undefined} | undefined} belief
 * @property {{seconds: number, drawings: Drawing[]}} picture
 * @property {Record<string, number>} values numbers to be plotted
 */

const MOST_LINES = 500;

/** @type {Thoughts} */
export const NO_THOUGHTS = { log: [], motion: { name: '', keyframe: 0 }, belief: undefined, picture: { seconds: 0, drawings: [] }, values: {} };

/** @param {string} team @param {number} number @returns {string} */
export function robotKey(team, number) {
  return `${team}\t${number}`;
}

/**
 * @param {ReadonlyMap<string, Thoughts>} all thoughts by robot
 * @param {readonly string[]} lines
 * @returns {Map<string, Thoughts>}
 */
export function withTelemetry(all, lines) {
  const next = new Map(all);
  for (const line of lines) {
    const [kind, seconds, team, number, ...fields] = line.split('\t').map(unescaped);
    const key = robotKey(team, Number(number));
    next.set(key, thought(next.get(key) ?? NO_THOUGHTS, kind, Number(seconds), fields));
  }
  return next;
}

/**
 * @param {Thoughts} thoughts
 * @param {string} kind
 * @param {number} seconds
 * @param {string[]} fields
 * @returns {Thoughts}
 */
function thought(thoughts, kind, seconds, fields) {
  switch (kind) {
    case 'log':
      return { ...thoughts, log: [...thoughts.log, { seconds, level: fields[0], text: fields[1] ?? '' }].slice(-MOST_LINES) };
    case 'motion':
      return { ...thoughts, motion: { name: fields[0], keyframe: Number(fields[1]) } };
    case 'belief':
      return { ...thoughts, belief: readBelief(fields) };
    case 'draw':
      return { ...thoughts, picture: { seconds, drawings: readDrawings(fields) } };
    case 'plot':
      return { ...thoughts, values: { ...thoughts.values, [fields[0]]: Number(fields[1]) } };
    default:
      return thoughts;
  }
}

/** @param {string[]} fields */
function readBelief(fields) {
  const knows = fields[0] !== '-';
  const self = knows ? fields.slice(0, 3).map(Number) : undefined;
  const things = [];
  for (let at = knows ? 3 : 1; at + 5 < fields.length; at += 6) {
    const [name, x, y, z, age, visible] = fields.slice(at, at + 6);
    things.push({ name, position: [x, y, z].map(Number), ageSeconds: Number(age), visible: visible === '1' });
  }
  return { things, self };
}

/** @param {string[]} fields @returns {Drawing[]} */
function readDrawings(fields) {
  const drawings = [];
  for (let at = 0; at + 4 < fields.length; ) {
    const [shape, colour] = fields.slice(at, at + 2);
    const place = fields.slice(at + 2, at + 5).map(Number);
    at += 5;
    const drawing = { shape, colour, place, to: place, radius: 0, text: '' };
    if (shape === 'line') {
      drawing.to = fields.slice(at, at + 3).map(Number);
      at += 3;
    } else if (shape === 'circle') {
      drawing.radius = Number(fields[at++]);
    } else if (shape === 'text') {
      drawing.text = fields[at++];
    }
    drawings.push(drawing);
  }
  return drawings;
}

/** @param {string} field */
function unescaped(field) {
  return field.replaceAll(/\\(.)/g, (_, sign) => ({ t: '\t', n: '\n', r: '\r' })[/** @type {'t'} */ (sign)] ?? sign);
}
