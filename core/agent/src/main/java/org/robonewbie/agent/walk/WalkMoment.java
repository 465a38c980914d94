package org.robonewbie.agent.walk;

import org.robonewbie.agent.perception.FootPressure;
import org.robonewbie.nao.kinematics.Leg;

/**
 * State of the walk in one cycle, as input to a reflex.
 *
 * @param swing the swing leg
 * @param phase step phase, 0 to 1
 * @param amplitude amplitude of the gait: 1 while walking, less in the first and last steps
 * @param wanted requested velocity
 * @param velocity velocity for which the current step was planned
 * @param pitchError forward tilt of the torso minus the planned tilt, degrees
 * @param pitchRate rate of the forward tilt, degrees per second
 * @param rollError tilt of the torso to the right minus the planned tilt, degrees
 * @param rollRate rate of the tilt to the right, degrees per second
 * @param turnRate turn rate of the torso to the left, degrees per second
 * @param left force on the left sole
 * @param right force on the right sole
 */
public record WalkMoment(
        Leg swing,
        double phase,
        double amplitude,
        WalkVelocity wanted,
        WalkVelocity velocity,
        double pitchError,
        double pitchRate,
        double rollError,
        double rollRate,
        double turnRate,
        FootPressure left,
        FootPressure right) {}
