/** What all pages share that watch something run: a search, a contest. */

/** @typedef {'waiting' | 'running' | 'ended' | 'lost' | 'refused'} Phase */

/** @param {Phase} phase @returns {Phase} what is left when the line is gone */
export function phaseWithoutLine(phase) {
  return phase === 'running' ? 'lost' : phase;
}

/**
 * The sentence that says where things stand.
 *
 * @param {{phase: Phase, refusal: string}} report
 * @param {{waiting: string, running: string, lost: string, ended: string}} words
 * @returns {{tone: string, text: string}}
 */
export function phaseSentence({ phase, refusal }, { waiting, running, lost, ended }) {
  switch (phase) {
    case 'waiting':
      return { tone: '', text: waiting };
    case 'lost':
      return { tone: 'trouble', text: `The program has ended or does not answer. ${lost}` };
    case 'refused':
      return { tone: 'trouble', text: refusal };
    case 'ended':
      return { tone: 'done', text: ended };
    default:
      return { tone: '', text: running };
  }
}
