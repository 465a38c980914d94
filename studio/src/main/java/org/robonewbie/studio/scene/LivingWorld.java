package org.robonewbie.studio.scene;

import org.robonewbie.nao.SoccerField;
import org.robonewbie.simulator.WorldSnapshot;

/** The running simulation, as scenes need it. */
public interface LivingWorld {

    /**
     * Tells on which pitch is played.
     *
     * @return the pitch
     */
    SoccerField field();

    /**
     * Gives the present state.
     *
     * @return the state
     * @throws IllegalStateException if there was none yet
     */
    WorldSnapshot now();

    /**
     * Goes on from a state, with the clock stopped. Puppets stand in for robots that do not play now.
     *
     * @param moment the state
     * @throws IllegalStateException if that is not possible; the message says why
     */
    void goOnFrom(KeptMoment moment);
}
