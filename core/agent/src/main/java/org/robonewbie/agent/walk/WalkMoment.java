package org.robonewbie.agent.walk;

import org.robonewbie.agent.perception.FootPressure;
import org.robonewbie.nao.kinematics.Leg;

/**
 * A moment of walking: where in its step the robot is and what it feels.
 *
 * @param swing which leg swings
 * @param phase which part of the step is over, 0 to 1
 * @param amplitude 1 while the robot walks, less in the first and the last step
 * @param wanted the velocity that the walk is asked for
 * @param velocity the velocity for which the present step was planned
 * @param pitchError how much further than planned the torso bows forward, degrees
 * @param pitchRate how fast it bows, degrees per second
 * @param rollError how much further than planned the torso leans to the right, degrees
 * @param rollRate how fast it leans to the right, degrees per second
 * @param turnRate how fast the torso turns to the left, degrees per second
 * @param left what the left sole feels
 * @param right what the right sole feels
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
