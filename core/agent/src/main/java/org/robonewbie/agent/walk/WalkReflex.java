package org.robonewbie.agent.walk;

import org.robonewbie.nao.motion.Posture;

/** Correction of the {@link WalkEngine}'s postures in each cycle, based on the robot's sensors. */
@FunctionalInterface
public interface WalkReflex {

    /** No correction. */
    WalkReflex NONE = (planned, moment) -> planned;

    /**
     * Corrects a posture.
     *
     * @param planned the engine's posture
     * @param moment state of the walk in this cycle
     * @return the corrected posture
     */
    Posture corrected(Posture planned, WalkMoment moment);

    /** {@return the reflex for one engine, which remembers nothing yet} */
    default WalkReflex forEngine() {
        return this;
    }
}
