/** Tile of one trial of a contest: its pitch from above, teams, time and play mode. */
import { shape, title } from '../panels/drawing.js';
import { element, setText } from '../panels/elements.js';
import { pitchSheet } from '../panels/pitch-sheet.js';
import { tileWords } from '../state/wall.js';

/** @typedef {import('../state/wall.js').Tile} Tile */

/** A robot from above, facing right: tip in front, shoulders behind. */
const STANDING = 'M.34 0L-.2.26-.1 0-.2-.26z';

export class TrialTile {
  #teams = element('strong');
  #time = element('span', { class: 'time' });
  #mode = element('span', { class: 'faint mode' });
  #link = element('span', { class: 'go' });
  #moving = shape('g');
  #ball = shape('circle', { r: 0.14, class: 'ball' });

  /** @param {Tile} tile @param {(id: string) => string} recording address of the recording of a trial */
  constructor(tile, recording) {
    const { id, length, width } = tile.trial;
    this.id = id;
    this.recording = recording;
    this.picture = element(
      'span',
      { class: 'sheet' },
      pitchSheet(length, width, goal(-length / 2), goal(length / 2), this.#moving, this.#ball),
    );
    this.root = element(
      'a',
      { class: 'tile panel', 'data-trial': id },
      element('span', { class: 'tile-head' }, this.#teams, this.#time),
      this.picture,
      element('span', { class: 'tile-foot' }, this.#mode, this.#link),
    );
    this.update(tile);
  }

  /** @param {Tile} tile */
  update(tile) {
    const { trial, running, moment } = tile;
    const { teams, time, mode } = tileWords(tile);
    setText(this.#teams, teams);
    setText(this.#time, time);
    setText(this.#mode, `${trial.id} · ${mode}`);
    setText(this.#link, running ? 'enlarge' : 'replay');
    this.root.setAttribute('href', running ? trial.studio : this.recording(trial.id));
    this.root.setAttribute('target', running ? `robonewbie-${trial.id}` : 'robonewbie-replay');
    this.root.dataset.running = String(running);
    if (moment) {
      const [x, y] = moment.ball;
      this.#ball.setAttribute('cx', String(x));
      this.#ball.setAttribute('cy', String(-y));
      this.#moving.replaceChildren(...moment.robots.map(robot));
    }
  }
}

/** @param {number} x */
function goal(x) {
  return shape('line', { x1: x, x2: x, y1: -1, y2: 1, class: 'goal' });
}

/** @param {import('../state/wall.js').WallRobot} robot */
function robot({ side, number, place: [x, y], heading, fallen }) {
  const name = title(`${number}${fallen ? ', fallen' : ''}`);
  const turn = `translate(${x} ${-y}) rotate(${-heading})`;
  return fallen
    ? shape(
        'rect',
        { class: `robot fallen ${side}`, x: -0.3, y: -0.12, width: 0.6, height: 0.24, transform: turn },
        name,
      )
    : shape('path', { class: `robot ${side}`, d: STANDING, transform: turn }, name);
}
