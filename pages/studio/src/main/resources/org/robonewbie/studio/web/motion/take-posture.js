/** The button that makes a keyframe of the posture of a robot in the run. */
import { button } from '../panels/elements.js';

/**
 * @param {() => void} take
 * @param {() => string} robotOfRun who gives the posture, empty if there is no robot
 */
export function takePosture(take, robotOfRun) {
  const made = button('Take posture', '', take, { id: 'take-posture' });
  return {
    button: made,
    draw() {
      const robot = robotOfRun();
      made.disabled = robot === '';
      made.title =
        robot === ''
          ? 'Start an agent: the posture of its robot can then become a keyframe'
          : `The posture of ${robot} in the run becomes a keyframe`;
    },
  };
}
