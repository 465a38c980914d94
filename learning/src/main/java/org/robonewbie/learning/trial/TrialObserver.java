package org.robonewbie.learning.trial;

/** Sees a robot after each cycle of a trial. */
@FunctionalInterface
public interface TrialObserver {

    /** The observer that never ends a trial. */
    TrialObserver NONE = robot -> true;

    /**
     * Observes the robot.
     *
     * @param robot the robot after a cycle; it may be pushed
     * @return whether the trial is to continue
     */
    boolean goOn(TrialRobot robot);

    /**
     * Combines two observers.
     *
     * @param other called after this one
     * @return an observer that continues while both want to
     */
    default TrialObserver and(TrialObserver other) {
        return robot -> {
            boolean first = goOn(robot);
            return other.goOn(robot) && first;
        };
    }
}
