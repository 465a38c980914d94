/** Scoreboard: teams, score, game time and play mode; hidden while a team is missing and there is no goal. */
import { scoreBoard } from '../state/studio-state.js';
import { byId, element, setText } from './elements.js';

/** @typedef {import('../state/studio-state.js').StudioState} StudioState */

/** @returns {(state: StudioState, now: number) => void} function that updates the scoreboard */
export function scoreBoardPanel() {
  const left = element('span', { class: 'team left' });
  const right = element('span', { class: 'team right' });
  const score = element('strong', { class: 'score' });
  const time = element('span', { class: 'clock' });
  const half = element('span');
  const mode = element('span', { class: 'mode' });
  byId('score-board').append(
    element('div', { class: 'score-line' }, left, score, right),
    element('div', { class: 'game-line' }, time, half, mode),
  );
  return (state, now) => {
    const board = scoreBoard(state, now);
    byId('score-board').hidden = !board.isGame;
    byId('score-board').dataset.cheers = board.cheers;
    setText(left, board.left);
    setText(right, board.right);
    left.classList.toggle('absent', !board.hasLeft);
    right.classList.toggle('absent', !board.hasRight);
    setText(score, board.score);
    setText(time, board.clock);
    setText(half, board.half);
    setText(mode, board.playMode);
  };
}
