/** Button that inserts a robot's posture from the running simulation as a keyframe. */
import { button } from '../panels/elements.js';

/**
 * @param {() => void} take
 * @param {() => string} robotOfRun name of the robot, empty if there is none
 */
export function takePosture(take, robotOfRun) {
  const made = button('Capture posture', '', take, { id: 'take-posture' });
  return {
    button: made,
    draw() {
      const robot = robotOfRun();
      made.disabled = robot === '';
      made.title =
        robot === ''
          ? 'Start an agent to use its robot’s posture as a keyframe'
          : `Uses the posture of ${robot} as a keyframe`;
    },
  };
}
