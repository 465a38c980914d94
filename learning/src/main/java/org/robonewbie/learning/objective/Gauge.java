package org.robonewbie.learning.objective;

/** Measures one trial: it sees the true state after each cycle and tells what has come out so far. */
public interface Gauge {

    /**
     * Looks at the world; the first look is the start of the trial.
     *
     * @param now the state after a cycle
     */
    void look(TrueState now);

    /** {@return the measured value in the objective's unit; always a number} */
    double value();
}
