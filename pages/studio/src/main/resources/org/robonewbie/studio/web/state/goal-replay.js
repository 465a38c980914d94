/** Replays a goal in slow motion shortly after it was scored, then returns to the present. Pure. */

const CYCLES_PER_SECOND = 50;
const BEFORE_SECONDS = 5;
const AFTER_SECONDS = 1.2;
const SPEED = 0.5;

export class GoalReplay {
  /** Cycle being replayed; undefined if there is no replay. @type {number | undefined} */
  at;
  /** @type {number | undefined} */
  #goal;

  /** @param {number} cycle cycle in which a goal was scored */
  scored(cycle) {
    this.#goal = cycle;
    this.at = undefined;
  }

  stop() {
    this.#goal = undefined;
    this.at = undefined;
  }

  /**
   * Advances the replay.
   *
   * @param {number} seconds since the last call
   * @param {{first: number, last: number}} history range of available cycles
   * @returns {'nothing' | 'shows' | 'ends'} whether to show `at`, or to return to the present
   */
  turn(seconds, { first, last }) {
    if (this.#goal === undefined) {
      return 'nothing';
    }
    const end = this.#goal + AFTER_SECONDS * CYCLES_PER_SECOND;
    if (this.at === undefined) {
      if (last < end + 1) {
        return 'nothing';
      }
      this.at = Math.max(first, this.#goal - BEFORE_SECONDS * CYCLES_PER_SECOND);
    } else {
      this.at += SPEED * CYCLES_PER_SECOND * seconds;
    }
    if (this.at < end) {
      return 'shows';
    }
    this.stop();
    return 'ends';
  }
}

/**
 * Describes which robots have joined or left.
 *
 * @param {ReadonlyArray<{team: string, number: number}>} before
 * @param {ReadonlyArray<{team: string, number: number}>} after
 * @returns {string[]}
 */
export function lineUpChanges(before, after) {
  const names = (/** @type {typeof before} */ players) =>
    players.filter(({ number }) => number > 0).map(({ team, number }) => `${team} ${number}`);
  const [were, are] = [names(before), names(after)];
  return [
    ...were.filter((name) => !are.includes(name)).map((name) => `${name} leaves`),
    ...are.filter((name) => !were.includes(name)).map((name) => `${name} joins`),
  ];
}
