/** Plots of arbitrary values over time, with several curves per plot and one time cursor shared by all rooms. */
import { button, choice, element, offer, setText } from '../panels/elements.js';
import { keep, recall } from '../panels/memory.js';
import { fixed } from '../state/numbers.js';
import { unitOf } from '../state/robot/signals.js';
import { tableOf } from '../state/robot/traces.js';
import { loadPlotter, newPlot } from './plotter.js';
import { ValueTree } from './value-tree.js';

/**
 * @typedef {import('../state/robot/robot-watch.js').RobotMoment} RobotMoment
 * @typedef {{names: string[], head: HTMLElement, place: HTMLElement, plot: any, drawn: string}} Row
 */

const KEY = 'robonewbie-plots';
const SPANS = [5, 20, 60, 300];
const FIRST = [
  ['torso/height'],
  ['ball/distance'],
  ['joint angle/left knee pitch', 'joint angle/right knee pitch'],
  ['accelerometer/forward', 'accelerometer/left', 'accelerometer/up'],
];

export class PlotController {
  /**
   * @param {HTMLElement} place
   * @param {(seconds: number) => void} goTo
   */
  constructor(place, goTo) {
    this.goTo = goTo;
    this.chosen = 0;
    this.span = 20;
    /** End of the visible range while the plots are paused. @type {number | undefined} */
    this.heldAt = undefined;
    /** @type {RobotMoment | undefined} */
    this.moment = undefined;
    this.list = element('div', { class: 'curves', id: 'curves' });
    const holding = 'Hold the curves; the simulation continues';
    this.pause = button('Hold', holding, () => this.hold(), { id: 'hold-curves' });
    const zoom = choice(
      { id: 'curve-span', 'aria-label': 'Time range of the curves', title: 'Time range of the curves' },
      SPANS.map((seconds) => [String(seconds), `${seconds} s`]),
      (seconds) => {
        this.span = Number(seconds);
      },
    );
    zoom.value = String(this.span);
    const table = button('CSV', 'Save the plotted values as a table', () => this.#offer(), { id: 'curves-csv' });
    const more = button('+ Plot', 'Add a plot; choose its values in the tree', () => this.add([]), {
      id: 'add-plot',
    });
    this.tree = new ValueTree((name) => this.toggle(name));
    const values = element(
      'details',
      { class: 'value-choice', id: 'value-choice' },
      element('summary', {}, 'Choose values'),
      this.tree.place,
    );
    place.append(element('div', { class: 'plot-bar' }, more, zoom, this.pause, table), values, this.list);
    /** @type {Row[]} */
    this.rows = [];
    stored().forEach((names) => this.add(names));
    loadPlotter().catch((error) => setText(this.list, error.message));
  }

  /** @param {readonly string[]} names */
  add(names) {
    const head = element('div', { class: 'plot-head' });
    const place = element('div', { class: 'plot' });
    const row = { names: [...names], head, place, plot: undefined, drawn: '' };
    const box = element('div', { class: 'plot-row', role: 'group', 'aria-label': 'Plot' }, head, place);
    box.addEventListener('pointerdown', () => this.#choose(row));
    this.rows.push(row);
    this.list.append(box);
    this.#choose(row);
  }

  /** @param {Row} row */
  #choose(row) {
    this.chosen = Math.max(0, this.rows.indexOf(row));
    this.rows.forEach((each) => each.head.parentElement?.classList.toggle('chosen', each === row));
  }

  /** Adds a value to the selected plot, or removes it if it is already plotted there. @param {string} name */
  toggle(name) {
    if (this.rows.length === 0) {
      this.add([]);
    }
    const row = this.rows[this.chosen];
    row.names = row.names.includes(name) ? row.names.filter((each) => each !== name) : [...row.names, name];
    this.#keep();
  }

  /** @param {Row} row */
  #remove(row) {
    row.plot?.destroy();
    row.head.parentElement?.remove();
    this.rows = this.rows.filter((each) => each !== row);
    this.#choose(this.rows[0]);
    this.#keep();
  }

  #keep() {
    keep(
      KEY,
      this.rows.map(({ names }) => names),
    );
  }

  hold() {
    this.heldAt = this.heldAt === undefined ? this.moment?.seconds : undefined;
    this.pause.setAttribute('aria-pressed', String(this.heldAt !== undefined));
  }

  /** @param {RobotMoment} moment @param {boolean} isLive whether the moment is the current one */
  draw(moment, isLive) {
    this.moment = moment;
    this.tree.draw(moment.traces, this.rows[this.chosen]?.names ?? []);
    const [from, to] = this.#range(moment, isLive);
    for (const row of this.rows) {
      this.#drawHead(row, moment);
      this.#drawRow(row, moment, from, to);
    }
  }

  /**
   * Returns the visible range in seconds: the most recent seconds, or a range centred on a past moment.
   *
   * @param {RobotMoment} moment
   * @param {boolean} isLive
   * @returns {[number, number]}
   */
  #range({ seconds, traces }, isLive) {
    const last = traces.extent.to;
    const to =
      this.heldAt ?? (isLive ? last : Math.max(Math.min(last, seconds + this.span / 2), Math.min(this.span, last)));
    return [Math.max(0, to - this.span), Math.max(to, 1)];
  }

  /** @param {Row} row @param {RobotMoment} moment */
  #drawHead(row, { traces, seconds }) {
    const values = row.names.map((name) => {
      const value = traces.valueAt(name, seconds);
      return `${name}\t${value === undefined ? '–' : `${fixed(value, 2)} ${unitOf(name)}`}`;
    });
    const key = values.join('\n');
    if (row.head.dataset.key !== key || !row.head.hasChildNodes()) {
      row.head.dataset.key = key;
      row.head.parentElement?.setAttribute('aria-label', `Plot of ${row.names.join(', ') || 'nothing'}`);
      const hint = 'Remove this plot';
      const remove = button('×', hint, () => this.#remove(row), { class: 'quiet', 'aria-label': hint });
      const parts = values.map((text, i) => element('span', { class: `curve-name curve-${i % 6}` }, ...named(text)));
      row.head.replaceChildren(
        ...(parts.length > 0 ? parts : [element('span', { class: 'faint' }, 'Choose values for this plot')]),
        remove,
      );
    }
  }

  /** @param {Row} row @param {RobotMoment} moment @param {number} from @param {number} to */
  #drawRow(row, { traces, seconds }, from, to) {
    const names = row.names.join('\n');
    const width = row.place.clientWidth;
    if (row.drawn !== `${names} ${width}` || (!row.plot && names !== '')) {
      row.plot?.destroy();
      row.drawn = `${names} ${width}`;
      row.plot = newPlot(row.place, row.names, {
        width,
        seek: (at) => this.goTo(at),
        zoomed: (span) => this.#zoom(span),
      });
    }
    if (row.plot) {
      row.plot.setData(traces.columns(row.names, from, to), false);
      row.plot.setScale('x', { min: from, max: to });
      row.plot.showMoment(seconds);
    }
  }

  /** @param {{from: number, to: number}} range */
  #zoom({ from, to }) {
    this.span = Math.max(0.2, to - from);
    this.heldAt = to;
    this.pause.setAttribute('aria-pressed', 'true');
  }

  #offer() {
    if (this.moment) {
      const { traces, seconds } = this.moment;
      const names = [...new Set(this.rows.flatMap((row) => row.names))];
      const [from, to] = this.#range(this.moment, seconds >= traces.extent.to);
      offer('robot.csv', tableOf(traces, names, from, to), 'text/csv');
    }
  }
}

/** @param {string} text */
function named(text) {
  const [name, value] = text.split('\t');
  return [`${name.split('/').join(': ')} `, element('strong', {}, value)];
}

/** @returns {string[][]} value names of each plot */
function stored() {
  const kept = recall(KEY, FIRST);
  const isWhole = Array.isArray(kept) && kept.length > 0 && kept.every(Array.isArray);
  return isWhole ? kept.map((names) => names.map(String)) : FIRST;
}
