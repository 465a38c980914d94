/** Robot log: lines at or above a minimum level, with the current line highlighted. Clicking a line jumps to its time. */
import { button, choice, element } from '../panels/elements.js';

/** @typedef {import('../state/robot/telemetry.js').LogLine} LogLine */

const LEVELS = ['DEBUG', 'INFO', 'WARNING', 'ERROR'];
const MAX_LINES = 300;
const NOTHING_SAID = 'This robot has logged nothing yet. Its program writes here with log.info("…").';
const HALF_CYCLE = 0.01;

/**
 * @param {HTMLElement} place
 * @param {(seconds: number) => void} goTo
 * @returns {(log: readonly LogLine[], seconds: number) => void}
 */
export function logList(place, goTo) {
  const level = choice(
    { id: 'log-level', 'aria-label': 'Minimum level' },
    LEVELS.map((each) => [each, each === 'DEBUG' ? 'all lines' : `${each.toLowerCase()} and above`]),
    () => {},
  );
  const list = element('ol', { class: 'log', 'aria-label': 'Log of the robot', tabindex: '0' });
  const silence = element('p', { class: 'faint' }, NOTHING_SAID);
  place.append(level, list, silence);
  let drawn = '';
  let marked = '';
  return (log, seconds) => {
    silence.hidden = log.length > 0;
    level.hidden = list.hidden = log.length === 0;
    const wanted = log.filter((line) => LEVELS.indexOf(line.level) >= LEVELS.indexOf(level.value));
    const last = wanted.findLastIndex((line) => line.seconds <= seconds + HALF_CYCLE);
    const shown = wanted.slice(Math.max(0, last + 50 - MAX_LINES), last + 50);
    const key = `${wanted.length} ${shown.length} ${shown[0]?.seconds} ${shown.at(-1)?.seconds} ${level.value}`;
    if (key !== drawn) {
      drawn = key;
      list.replaceChildren(...shown.map((line) => row(line, goTo)));
    }
    const line = wanted[last];
    const mark = `${key} ${shown.indexOf(line)}`;
    if (mark !== marked) {
      marked = mark;
      markLine(list, shown.indexOf(line));
    }
  };
}

/** @param {HTMLElement} list @param {number} index */
function markLine(list, index) {
  [...list.children].forEach((child, i) => {
    child.toggleAttribute('aria-current', i === index);
    child.classList.toggle('later', i > index);
  });
  const line = /** @type {HTMLElement | undefined} */ (list.children[index]);
  if (line) {
    list.scrollTop = line.offsetTop + line.offsetHeight - list.clientHeight;
  }
}

/** @param {LogLine} line @param {(seconds: number) => void} goTo */
function row({ seconds, level, text }, goTo) {
  const time = `${seconds.toFixed(2)} s`;
  const link = button(time, 'Show this moment', () => goTo(seconds), { class: 'quiet log-time' });
  return element('li', { class: level.toLowerCase() }, link, ` ${level === 'INFO' ? '' : `${level} `}${text}`);
}
