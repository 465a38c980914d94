/** Code shared by pages that observe a running process, such as a search or a contest. */

/** @typedef {'waiting' | 'running' | 'ended' | 'lost' | 'refused'} Phase */

/** @param {Phase} phase @returns {Phase} the phase after the connection was lost */
export function phaseWithoutLine(phase) {
  return phase === 'running' ? 'lost' : phase;
}

/**
 * Describes the state of the process in a sentence.
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
      return { tone: 'trouble', text: `The program has ended or is not responding. ${lost}` };
    case 'refused':
      return { tone: 'trouble', text: refusal };
    case 'ended':
      return { tone: 'done', text: ended };
    default:
      return { tone: '', text: running };
  }
}
