/** Selects a second run for comparison and shows the distances between the two runs. */
import { shape } from '../panels/drawing.js';
import { choice, element, setEntries, setText } from '../panels/elements.js';
import { curveOf, differences, withGhosts } from '../state/replay/comparison.js';
import { frameOf, sceneOf } from '../state/replay/replay-state.js';
import { RecordingFile } from './recordings.js';

/**
 * @typedef {import('../state/replay/comparison.js').Picture} Picture
 * @typedef {import('./recording-api.js').RecordingEntry} RecordingEntry
 */

const POINTS = 200;
const HEIGHT = 26;

export class ComparisonPanel {
  /**
   * @param {Record<string, import('../state/kinematics.js').RobotModel>} models
   * @param {{changed: () => void, note: (text: string) => void}} listener
   */
  constructor(models, listener) {
    this.models = models;
    this.listener = listener;
    /** @type {RecordingFile | undefined} */
    this.file = undefined;
    const look = { id: 'compare-with', 'aria-label': 'Compare with', title: 'Shows a second run as grey ghosts' };
    this.choice = choice(look, [], (name) => this.#choose(name));
    this.reading = element('span', { class: 'faint', id: 'compare-reading' });
    this.polyline = shape('polyline');
    const box = { class: 'compare-curve', viewBox: `0 0 ${POINTS} ${HEIGHT}`, preserveAspectRatio: 'none' };
    this.scale = element('span', {
      class: 'faint',
      title: 'Distance between the two balls over time, or between the first robots if the balls agree',
    });
    const curve = shape('svg', box, this.polyline);
    this.line = element('div', { class: 'compare-line', hidden: '' }, this.scale, curve, this.reading);
    this.listed = '';
    this.drawn = '';
    /** @type {{own: unknown, other: unknown, picture: Picture} | undefined} */
    this.last = undefined;
  }

  /** @param {readonly RecordingEntry[]} entries @param {string} own name of the displayed run */
  list(entries, own) {
    const names = entries.map(({ name }) => name).filter((name) => name !== own);
    const key = names.join('\n');
    if (key !== this.listed) {
      this.listed = key;
      setEntries(this.choice, [['', 'Compare with…'], ...names.map((name) => /** @type {const} */ ([name, name]))]);
    }
    this.choice.value = this.file?.name ?? '';
    this.choice.hidden = names.length === 0;
  }

  /** @param {string} name */
  #choose(name) {
    this.file?.close();
    this.file = undefined;
    this.last = undefined;
    if (name) {
      const file = new RecordingFile(name, this.models, this.listener.changed);
      this.file = file;
      file.load(false).catch((error) => this.listener.note(error.message));
    }
    this.listener.changed();
  }

  /** @param {Picture} own @param {number} index @returns {Picture} the picture, with ghosts if there is a second run */
  picture(own, index) {
    const moment = this.file?.run.at(Math.round(index));
    if (!moment || !this.file) {
      return own;
    }
    const scene = sceneOf(moment, this.file.run.header, this.models, 0);
    const other = { scene, frame: frameOf(moment, scene) };
    const both = withGhosts(own, other);
    const same = this.last?.own === own.scene && this.last.other === moment.robots;
    const picture = { scene: same && this.last ? this.last.picture.scene : both.scene, frame: both.frame };
    this.last = { own: own.scene, other: moment.robots, picture };
    setText(
      this.reading,
      `Here: ${differences(own, other)
        .map(({ name, metres }) => `${name} ${metres.toFixed(2)} m`)
        .slice(0, 4)
        .join(' · ')}`,
    );
    return picture;
  }

  /** @param {import('../state/replay/recorded-run.js').RecordedRun | undefined} own */
  draw(own) {
    const other = this.file?.run;
    this.line.hidden = !other;
    const key = `${own?.count} ${other?.count} ${this.file?.name}`;
    if (own && other && key !== this.drawn) {
      this.drawn = key;
      const curve = curveOf({ count: own.count, ...own.summary }, { count: other.count, ...other.summary }, POINTS);
      const max = Math.max(0.05, ...curve);
      setText(this.scale, `Distance, 0 to ${max.toFixed(2)} m`);
      this.polyline.setAttribute(
        'points',
        curve.map((metres, i) => `${i},${(HEIGHT - 1 - ((HEIGHT - 2) * metres) / max).toFixed(1)}`).join(' '),
      );
    }
  }
}
