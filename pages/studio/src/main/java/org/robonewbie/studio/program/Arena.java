package org.robonewbie.studio.program;

import java.util.OptionalInt;
import java.util.function.BooleanSupplier;

/** The pitch on which programs run; its state survives the replacement of a program. */
public interface Arena {

    /** {@return the TCP port to which programs connect; empty if there is none} */
    OptionalInt agentPort();

    /**
     * Saves the current state, to be restored when another program has replaced the running one.
     *
     * @return the saved state
     */
    Moment keep();

    /** Discards the log and the errors of the previous program. */
    void clearTelemetry();

    /** Resets the robots, the ball, the time and the score. */
    void reset();

    /** Resumes the clock; programs can join only while it runs. */
    void resume();

    /** A saved state. */
    interface Moment {

        /**
         * Waits until a robot of the new program has joined, then restores the state. Gives up after a timeout.
         *
         * @param isWanted polled while waiting; false cancels the wait
         */
        void restore(BooleanSupplier isWanted);
    }
}
