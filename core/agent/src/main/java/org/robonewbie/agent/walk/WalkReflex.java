package org.robonewbie.agent.walk;

import org.robonewbie.nao.motion.Posture;

/** Changes the postures of the {@link WalkEngine}, cycle by cycle, by what the robot feels. */
@FunctionalInterface
public interface WalkReflex {

    /** Walks as planned. */
    WalkReflex NONE = (planned, moment) -> planned;

    /**
     * Changes one posture.
     *
     * @param planned the engine's
     * @param moment where in its step the robot is and what it feels
     * @return where the joints go instead
     */
    Posture corrected(Posture planned, WalkMoment moment);
}
