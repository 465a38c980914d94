package org.robonewbie.learning.trial;

/** Sees a robot after each cycle of a trial. */
@FunctionalInterface
public interface TrialObserver {

    /** Lets everything go on. */
    TrialObserver NONE = robot -> true;

    /**
     * Looks at the robot.
     *
     * @param robot the robot after a cycle; it may be pushed
     * @return whether the trial shall go on
     */
    boolean goOn(TrialRobot robot);

    /**
     * Lets another observer look as well.
     *
     * @param other looks after this one
     * @return an observer that goes on while both want to
     */
    default TrialObserver and(TrialObserver other) {
        return robot -> {
            boolean first = goOn(robot);
            return other.goOn(robot) && first;
        };
    }
}
