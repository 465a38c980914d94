/**
 * Incremental reader of recordings; docs/recording-format.md describes the format. Pure.
 *
 * @typedef {object} Game
 * @property {string} playMode
 * @property {number} half
 * @property {number} scoreLeft
 * @property {number} scoreRight
 * @property {string} left
 * @property {string} right
 *
 * @typedef {import('../../live/state-frame.js').Player} Player
 * @typedef {import('../kinematics.js').RobotModel} RobotModel
 *
 * @typedef {object} Moment one cycle
 * @property {number} cycle
 * @property {number} gameTime seconds
 * @property {Game} game
 * @property {Player[]} robots
 * @property {CommandedSpeeds} speeds degrees per second by hinge, for each commanded robot
 * @property {import('./recorded-things.js').RecordedThing[]} [things] other objects on the pitch
 * @property {Record<string, RobotModel>} [models] the models that the recording defines
 * @property {Int32Array} numbers the ball's pose, then for each robot the torso's pose and the hinges' angles, in the file's units
 *
 * @typedef {object} RecordedEvent
 * @property {number} index index of the moment
 * @property {'goal' | 'foul' | 'playmode' | 'fall' | 'warning' | 'log'} kind
 * @property {string} text
 */
import { CYCLE_SECONDS } from '../cycle.js';
import { CommandedSpeeds } from './commanded-speeds.js';
import { readThings, withMoved } from './recorded-things.js';
import { EndOfBytes, KIND, MAGIC, POSE_NUMBERS, SIDES, Source, VERSION } from './recording-source.js';

const DEGREES_PER_STEP = 180 / Math.PI / 10_000;

export class RecordingReader {
  /**
   * @param {(type: string) => number} hingesOf number of hinges of a robot type
   * @param {{rosters: Map<string, Player[]>, models: Record<string, RobotModel>, isBegun: boolean}} [part] for reading part of a recording:
   *     the rosters and models known from other parts; the first records of the part restore the state
   */
  constructor(hingesOf, part = { rosters: new Map(), models: {}, isBegun: false }) {
    this.models = part.models;
    /** @param {string} type */
    this.hingesOf = (type) => this.models[type]?.hinges.length ?? hingesOf(type);
    this.rosters = part.rosters;
    /** @type {Moment[]} */
    this.moments = [];
    /** @type {RecordedEvent[]} */
    this.events = [];
    /** @type {Record<string, string>} */
    this.header = {};
    this.rest = new Uint8Array();
    this.begun = part.isBegun;
    /** @type {Game} */
    this.game = { playMode: 'BeforeKickOff', half: 1, scoreLeft: 0, scoreRight: 0, left: '', right: '' };
    /** @type {Player[]} */
    this.robots = [];
    /** @type {import('./recorded-things.js').RecordedThing[]} */
    this.things = [];
    this.ticks = 0;
    this.ball = new Int32Array(POSE_NUMBERS);
    /** @type {Map<number, Int32Array>} */
    this.tracks = new Map();
    this.speeds = new CommandedSpeeds();
    /** Whether the speeds may be changed in place, because no finished moment shares them. */
    this.areSpeedsNew = true;
  }

  /**
   * Parses the next decompressed bytes of the recording.
   *
   * @param {Uint8Array} bytes
   * @throws {Error} if it is not a recording; the message is meant for the user
   */
  push(bytes) {
    const all = new Uint8Array(this.rest.length + bytes.length);
    all.set(this.rest);
    all.set(bytes, this.rest.length);
    const source = new Source(all);
    let good = 0;
    try {
      if (!this.begun) {
        this.#begin(source);
      }
      good = source.at;
      while (source.at < all.length) {
        this.#record(source);
        good = source.at;
      }
    } catch (error) {
      if (!(error instanceof EndOfBytes)) {
        throw error;
      }
    }
    this.rest = all.slice(good);
  }

  /** @param {Source} source */
  #begin(source) {
    const magic = String.fromCharCode(...source.bytes(MAGIC.length));
    if (magic !== MAGIC) {
      throw new Error('This is not a RoboNewbie recording, or it is damaged.');
    }
    const version = source.unsigned();
    if (version !== VERSION) {
      throw new Error(`This recording has version ${version}; this page reads version ${VERSION}.`);
    }
    this.begun = true;
  }

  /** @param {Source} source */
  #record(source) {
    const kind = source.bytes(1)[0];
    const content = new Source(source.bytes(source.unsigned()));
    if (kind === KIND.HEADER) {
      this.header = Object.fromEntries(
        content
          .text()
          .split('\n')
          .map((line) => line.split(/=(.*)/s).slice(0, 2)),
      );
    } else if (kind === KIND.GAME) {
      const playMode = content.text();
      const [half, scoreLeft, scoreRight] = [content.unsigned(), content.unsigned(), content.unsigned()];
      this.game = { playMode, half, scoreLeft, scoreRight, left: content.text(), right: content.text() };
    } else if (kind === KIND.MODEL) {
      this.#model(content);
    } else if (kind === KIND.ROBOTS) {
      this.robots = this.#roster(content);
    } else if (kind === KIND.COMMANDS) {
      this.#commands(content);
    } else if (kind === KIND.EVENT) {
      this.#event(content.text());
    } else if (kind === KIND.CYCLE) {
      this.#cycle(content);
    } else if (kind === KIND.STATE) {
      this.#resume(content);
    } else if (kind === KIND.THINGS) {
      this.things = readThings(content);
    } else if (kind === KIND.MOVED_THING) {
      this.things = withMoved(this.things, content);
    }
  }

  /** Reads the model of a robot type, unless another part has defined it. @param {Source} content */
  #model(content) {
    const type = typeName(content.unsigned());
    content.unsigned();
    this.models[type] ??= JSON.parse(content.text());
  }

  /** Reads a roster; equal rosters share one list in all parts of a recording. @param {Source} content */
  #roster(content) {
    const key = content.content.join();
    const roster = this.rosters.get(key) ?? Array.from({ length: content.unsigned() }, () => readRobot(content));
    this.rosters.set(key, roster);
    return roster;
  }

  /** Restores the state at the beginning of this part. @param {Source} content */
  #resume(content) {
    this.ticks = content.signed();
    readTrack(this.ball, content);
    while (content.at < content.content.length) {
      const id = content.unsigned();
      const track = new Int32Array(content.unsigned());
      readTrack(track, content);
      this.tracks.set(id, track);
    }
  }

  /** @param {Source} content */
  #commands(content) {
    const id = content.unsigned();
    this.speeds = this.areSpeedsNew ? this.speeds : this.speeds.copy();
    this.areSpeedsNew = true;
    const speeds = this.speeds.of(id);
    for (let count = content.unsigned(); count > 0; count--) {
      const hinge = content.unsigned();
      speeds[hinge] = content.signed() * DEGREES_PER_STEP;
    }
  }

  /** @param {string} text */
  #event(text) {
    const [kind, ...words] = text.split(' ');
    if (kind === 'goal' || kind === 'foul' || kind === 'playmode' || kind === 'fall') {
      this.events.push({ index: this.moments.length, kind, text: words.join(' ') });
    }
  }

  /** @param {Source} content */
  #cycle(content) {
    const cycle = content.unsigned();
    this.ticks += content.signed();
    const sizes = this.robots.map(({ type }) => POSE_NUMBERS + this.hingesOf(type));
    const numbers = new Int32Array(POSE_NUMBERS + sizes.reduce((sum, size) => sum + size, 0));
    readTrack(this.ball, content);
    numbers.set(this.ball);
    let at = POSE_NUMBERS;
    this.robots.forEach(({ id }, i) => {
      const known = this.tracks.get(id);
      const track = known?.length === sizes[i] ? known : new Int32Array(sizes[i]);
      this.tracks.set(id, track);
      readTrack(track, content);
      numbers.set(track, at);
      at += sizes[i];
    });
    this.areSpeedsNew = false;
    this.moments.push({
      cycle,
      gameTime: this.ticks * CYCLE_SECONDS,
      game: this.game,
      robots: this.robots,
      speeds: this.speeds,
      things: this.things,
      models: this.models,
      numbers,
    });
  }
}

/** @param {Source} content @returns {Player} */
function readRobot(content) {
  const id = content.unsigned();
  const type = typeName(content.unsigned());
  const side = SIDES[content.unsigned()];
  return { id, type, side, number: content.unsigned(), team: content.text() };
}

/** @param {number} index */
const typeName = (index) => `TYPE_${index}`;

/** @param {Int32Array} track @param {Source} content */
function readTrack(track, content) {
  for (let i = 0; i < track.length; i++) {
    track[i] += content.signed();
  }
}
