/** Perceptors of a robot: accelerometer, gyroscope, feet, hearing, and the referee's game state. */
import { label, shape } from '../panels/drawing.js';
import { element, setText } from '../panels/elements.js';
import { fixed } from '../state/numbers.js';

/**
 * @typedef {import('../state/robot/senses.js').Senses} Senses
 * @typedef {import('../state/kinematics.js').RobotModel} RobotModel
 */

const FEET = { lf: 'left', rf: 'right' };
const NEWTONS_PER_METRE = 2500;
const NAMES = ['Accelerometer', 'Gyroscope', 'Left foot', 'Right foot', 'Hears', 'Says', 'Game'];

/**
 * @param {HTMLElement} place
 * @returns {(senses: Senses, said: string[], model: RobotModel) => void}
 */
export function sensesPanel(place) {
  const values = Object.fromEntries(NAMES.map((name) => [name, element('dd', {})]));
  const lines = NAMES.flatMap((name) => [element('dt', {}, name), values[name]]);
  const soles = shape('svg', { class: 'soles', viewBox: '-0.13 -0.1 0.26 0.2', role: 'img' });
  soles.setAttribute('aria-label', 'Ground forces on the feet; the toes point up');
  place.append(element('dl', { class: 'senses' }, ...lines), soles);
  return (senses, said, model) => {
    setText(values.Accelerometer, vector(senses.acceleration, 1, 'm/s²'));
    setText(values.Gyroscope, vector(senses.gyro, 0, '°/s'));
    setText(values['Left foot'], foot(senses.feet.lf, senses.now));
    setText(values['Right foot'], foot(senses.feet.rf, senses.now));
    keepText(values.Hears, senses.heard.map(({ from, text }) => `“${text}” from ${from}`).join(', '));
    keepText(values.Says, said.map((text) => `“${text}”`).join(', '));
    setText(values.Game, game(senses.game));
    drawSoles(soles, senses, model);
  };
}

/** Shows the last message heard until another one arrives. @param {Element} target @param {string} said */
function keepText(target, said) {
  setText(target, said || target.textContent || '–');
}

/** @param {number[] | undefined} numbers @param {number} digits @param {string} unit */
function vector(numbers, digits, unit) {
  return numbers
    ? `${['forward', 'left', 'up'].map((name, i) => `${name} ${fixed(numbers[i], digits)}`).join(', ')} ${unit}`
    : '–';
}

/**
 * @param {import('../state/robot/senses.js').FootForce | undefined} force
 * @param {number | undefined} now time of the message; undefined if there is none
 */
function foot(force, now) {
  if (now === undefined) {
    return '–';
  }
  return force
    ? `${fixed(Math.hypot(...force.force), 0)} N, forward ${fixed(force.contact[0] * 1000, 0)}, left ${fixed(force.contact[1] * 1000, 0)} mm`
    : 'no contact';
}

/** @param {Record<string, string>} state */
function game(state) {
  const score = state.sl === undefined ? '' : `, ${state.sl} : ${state.sr}`;
  return state.pm === undefined ? '–' : `${state.pm} at ${state.t} s${score}`;
}

/** @param {SVGElement} soles @param {Senses} senses @param {RobotModel} model */
function drawSoles(soles, senses, model) {
  const shapes = Object.entries(FEET).flatMap(([name, side], i) => {
    const middle = i === 0 ? -0.06 : 0.06;
    const force = senses.feet[name];
    const press = force ? [pressOf(force, middle)] : [];
    return [soleOf(side, middle, model), ...press, label(side[0].toUpperCase(), middle - 0.007, 0.076, 'sole-text')];
  });
  soles.replaceChildren(...shapes);
}

/** @param {string} side @param {number} middle @param {RobotModel} model */
function soleOf(side, middle, model) {
  const [width, height] = model.links.find((link) => link.name === `${side[0]}foot`)?.size ?? [0.08, 0.16, 0.03];
  return shape('rect', { class: 'sole', x: middle - width / 2, y: -height / 2, width, height, rx: 0.02 });
}

/** @param {import('../state/robot/senses.js').FootForce} force @param {number} middle */
function pressOf({ force, contact }, middle) {
  const r = Math.min(0.05, 0.004 + Math.hypot(...force) / NEWTONS_PER_METRE);
  return shape('circle', { class: 'press', cx: middle - contact[1], cy: -contact[0], r });
}
