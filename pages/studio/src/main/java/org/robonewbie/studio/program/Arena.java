package org.robonewbie.studio.program;

import java.util.OptionalInt;
import java.util.function.BooleanSupplier;

/** The pitch on which programs run, and whose state survives the change of a program. */
public interface Arena {

    /** {@return the TCP port at which programs join; empty where they cannot} */
    OptionalInt agentPort();

    /**
     * Keeps the present moment, to go on from when another program has taken the place of the one that runs.
     *
     * @return the moment
     */
    Moment keep();

    /** Puts robots, ball, time and score back to the start. */
    void reset();

    /** Lets the clock go on, without which nobody can join. */
    void resume();

    /** A kept moment. */
    interface Moment {

        /**
         * Waits until as many robots play as at this moment, and lets the world go on from it.
         *
         * @param stillWanted looked at now and then; false ends the waiting
         */
        void goOn(BooleanSupplier stillWanted);
    }
}
