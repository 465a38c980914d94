/**
 * Parser of telemetry lines, written by the Java class TelemetryLine. Pure.
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
 * @typedef {{things: BelievedThing[], self: number[] | undefined}} Belief
 * @typedef {{name: string, keyframe: number}} MotionProgress
 *
 * @typedef {{seconds: number, robot: string} & ( {kind: 'log', log: LogLine} | {kind: 'motion', motion: MotionProgress} | {kind: 'belief',
 *     belief: Belief}
 * | {kind: 'draw', drawings: Drawing[]} | {kind: 'plot', name: string, value: number}
 * | {kind: 'number', number: import('../program/sliders.js').DeclaredNumber} | {kind: 'other'})} TelemetryItem
 */

/** @param {string} team @param {number} number @returns {string} */
export function robotKey(team, number) {
  return `${team}\t${number}`;
}

/** @param {string} line @returns {TelemetryItem} */
export function readTelemetry(line) {
  const [kind, time, team, number, ...fields] = line.split('\t').map(unescaped);
  const seconds = Number(time);
  const base = { seconds, robot: robotKey(team, Number(number)) };
  switch (kind) {
    case 'log':
      return { ...base, kind, log: { seconds, level: fields[0], text: fields[1] ?? '' } };
    case 'motion':
      return { ...base, kind, motion: { name: fields[0], keyframe: Number(fields[1]) } };
    case 'belief':
      return { ...base, kind, belief: readBelief(fields) };
    case 'draw':
      return { ...base, kind, drawings: readDrawings(fields) };
    case 'plot':
      return { ...base, kind, name: fields[0], value: Number(fields[1]) };
    case 'number': {
      const [defaultValue, min, max, value] = fields.slice(1).map(Number);
      return { ...base, kind, number: { name: fields[0], defaultValue, min, max, value } };
    }
    default:
      return { ...base, kind: 'other' };
  }
}

/** @param {string[]} fields @returns {Belief} */
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
  for (let at = 0; at + 4 < fields.length;) {
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
