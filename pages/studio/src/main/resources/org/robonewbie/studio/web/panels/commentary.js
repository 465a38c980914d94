/** Commentary on a match: optional goal replays, and notices when robots join or leave. */
import { GoalReplay, lineUpChanges } from '../state/goal-replay.js';
import { byId, check } from './elements.js';
import { keep, recall } from './memory.js';

const KEY = 'robonewbie-goal-replays';

export class Commentary {
  #replay = new GoalReplay();
  /** @type {number | undefined} */
  #goalSeen;
  /** The cycle to which the replay has set the cursor. @type {number | undefined} */
  #shown;
  /** @type {import('../live/state-frame.js').Scene | undefined} */
  #scene;

  /** @param {import('../live/session.js').Session} session @param {(sentence: string) => void} announce */
  constructor(session, announce) {
    this.session = session;
    this.announce = announce;
    const { box, label } = check('goal-replays', 'Replay goals', 'Replays each goal in slow motion', (on) => {
      keep(KEY, on);
      this.#stop();
    });
    box.checked = recall(KEY, false);
    this.box = box;
    byId('cameras').append(label);
  }

  /** @param {number} seconds since the last call */
  turn(seconds) {
    const { state, cursor } = this.session;
    this.#announceChanges(state);
    if (state.goal?.milliseconds !== this.#goalSeen) {
      this.#goalSeen = state.goal?.milliseconds;
      if (state.goal && this.box.checked && cursor.cycle === undefined && !cursor.recorded) {
        this.#replay.scored(state.frame?.cycle ?? 0);
      }
    }
    const wasMoved = this.#shown !== undefined && cursor.cycle !== this.#shown;
    if (wasMoved || cursor.recorded) {
      this.#stop();
      return;
    }
    const now = this.#replay.turn(seconds, cursor.history);
    if (now === 'shows') {
      this.session.travel(() => cursor.goTo(this.#replay.at ?? 0));
      this.#shown = cursor.cycle;
    } else if (now === 'ends') {
      this.session.travel(() => cursor.goLive());
      this.#shown = undefined;
    }
    byId('goal-again').hidden = this.#shown === undefined;
  }

  #stop() {
    this.#replay.stop();
    this.#shown = undefined;
    byId('goal-again').hidden = true;
  }

  /** @param {import('../state/studio-state.js').StudioState} state */
  #announceChanges({ scene, frame }) {
    if (scene !== this.#scene) {
      const before = this.#scene;
      this.#scene = scene;
      if (before && scene && (frame?.gameTime ?? 0) > 0) {
        lineUpChanges(before.robots, scene.robots).forEach((sentence) => this.announce(sentence));
      }
    }
  }
}
