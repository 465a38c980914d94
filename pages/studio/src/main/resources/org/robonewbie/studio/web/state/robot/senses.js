/**
 * Interprets messages between a robot and the simulator. Vectors use the framework's axes (forward, left, up), whereas SimSpark's axes are
 * right, forward, up. Pure.
 *
 * @typedef {import('./expressions.js').Expression} Expression
 *
 * @typedef {object} SeenThing
 * @property {string} name
 * @property {'ball' | 'post' | 'flag' | 'player'} kind
 * @property {Array<{name: string, polar: number[]}>} points distance in metres, degrees to the left, degrees up
 * @property {string} team team of a player
 *
 * @typedef {object} FootForce
 * @property {number[]} contact metres from the centre of the foot
 * @property {number[]} force newtons
 *
 * @typedef {object} Senses
 * @property {number | undefined} now seconds
 * @property {Record<string, string>} game game state, keyed by SimSpark's names
 * @property {number[] | undefined} gyro degrees per second about the forward, left and up axes
 * @property {number[] | undefined} acceleration metres per second squared
 * @property {Record<string, FootForce>} feet forces by SimSpark's names: lf, rf and, for a robot with toes, lf1, rf1
 * @property {Array<{seconds: number, from: string, text: string}>} heard
 * @property {{things: SeenThing[], lines: number[][][]} | undefined} seen undefined in messages without camera data
 */
import { numbers, part, readExpressions } from './expressions.js';

/** @param {string} message message from the simulator @returns {Senses} */
export function readSenses(message) {
  /** @type {Senses} */
  const senses = {
    now: undefined,
    game: {},
    gyro: undefined,
    acceleration: undefined,
    feet: {},
    heard: [],
    seen: undefined,
  };
  for (const expression of readExpressions(message)) {
    if (typeof expression !== 'string') {
      sense(senses, expression);
    }
  }
  return senses;
}

/** @param {Senses} senses @param {Expression[]} expression */
function sense(senses, expression) {
  switch (expression[0]) {
    case 'time':
      senses.now = numbers(part(expression, 'now'))[0];
      break;
    case 'GS':
      senses.game = Object.fromEntries(expression.slice(1).map((each) => [each[0], String(each[1])]));
      break;
    case 'GYR':
      senses.gyro = toBodyFrame(numbers(part(expression, 'rt')));
      break;
    case 'ACC':
      senses.acceleration = toBodyFrame(numbers(part(expression, 'a')));
      break;
    case 'FRP':
      senses.feet[String(part(expression, 'n')?.[1])] = {
        contact: toBodyFrame(numbers(part(expression, 'c'))),
        force: toBodyFrame(numbers(part(expression, 'f'))),
      };
      break;
    case 'hear':
      senses.heard.push(heard(expression));
      break;
    case 'See':
      senses.seen = seen(expression);
      break;
  }
}

/** @param {number[]} raw right, forward, up @returns {number[]} forward, left, up */
function toBodyFrame([right, forward, up]) {
  return [forward, right === 0 ? 0 : -right, up];
}

/** Reads a message that the robot has heard; some servers send the team first. @param {Expression[]} expression */
function heard(expression) {
  const at = Number.isNaN(Number(expression[1])) ? 2 : 1;
  const from = String(expression[at + 1]);
  const direction = from === 'self' ? 'itself' : `${from}°`;
  const team = at === 2 && from !== 'self' ? `${expression[1]} at ` : '';
  return {
    seconds: Number(expression[at]),
    from: team + direction,
    text: expression
      .slice(at + 2)
      .map(String)
      .join(' '),
  };
}

/** @param {Expression[]} expression */
function seen(expression) {
  /** @type {SeenThing[]} */
  const things = [];
  /** @type {number[][][]} */
  const lines = [];
  for (const each of expression.slice(1)) {
    const name = String(each[0]);
    const points =
      typeof each === 'string'
        ? []
        : each.flatMap((item) => (item[0] === 'pol' ? [numbers(/** @type {Expression[]} */ (item))] : []));
    if (name === 'L') {
      lines.push(points);
    } else if (name === 'P') {
      things.push(player(/** @type {Expression[]} */ (each)));
    } else if (points.length > 0) {
      const kind = name === 'B' ? 'ball' : name.startsWith('G') ? 'post' : 'flag';
      things.push({ name, kind, team: '', points: [{ name, polar: points[0] }] });
    }
  }
  return { things, lines };
}

/** @param {Expression[]} expression @returns {SeenThing} */
function player(expression) {
  const team = String(part(expression, 'team')?.[1] ?? '');
  const number = String(part(expression, 'id')?.[1] ?? '');
  const points = expression.flatMap((each) => {
    const polar = part(each, 'pol');
    return polar ? [{ name: String(each[0]), polar: numbers(polar) }] : [];
  });
  return { name: `${team} ${number}`.trim(), kind: 'player', team, points };
}

/**
 * Reads the commands of an agent.
 *
 * @param {string} message message from the agent
 * @returns {{speeds: Record<string, number>, said: string[]}} speeds in degrees per second by effector, and the spoken messages
 */
export function readOrders(message) {
  /** @type {Record<string, number>} */
  const speeds = {};
  /** @type {string[]} */
  const said = [];
  for (const expression of readExpressions(message)) {
    const [name, ...values] = expression;
    if (name === 'say') {
      said.push(values.map(String).join(' '));
    } else if (values.length === 1 && /^[hlr][a-z]*\d+$/.test(String(name))) {
      speeds[String(name)] = (Number(values[0]) * 180) / Math.PI;
    }
  }
  return { speeds, said };
}
