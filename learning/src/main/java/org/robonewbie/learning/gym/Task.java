package org.robonewbie.learning.gym;

import java.util.List;
import java.util.SplittableRandom;
import org.robonewbie.learning.experiment.ObservedQuantity;
import org.robonewbie.learning.experiment.SoccerTrial;
import org.robonewbie.learning.experiment.TrialSetting;
import org.robonewbie.nao.Joint;

/**
 * Something to learn for one robot. An action has a number between -1 and 1 for each of the task's joints: the angle to go to,
 * as a part of {@link #rangeDegrees} from the first posture.
 */
interface Task {

    /** Names the task, such as {@code Walk}. */
    String name();

    /** Tells how each episode begins. */
    TrialSetting setting();

    /** Lists the joints that an action moves; the others stay as they are. */
    List<Joint> joints();

    /** Tells how far an action of 1 is from the first posture. */
    double rangeDegrees();

    /** Tells after how many cycles an episode ends. */
    int longestCycles();

    /** Names what is observed besides the perceptors. */
    default List<ObservedQuantity> extras() {
        return List.of();
    }

    /** Begins an episode in a trial that has just been reset. */
    Episode begin(SoccerTrial trial, SplittableRandom random);

    /** One attempt. */
    interface Episode {

        /** Does what happens to the robot, such as pushes. */
        default void beforeStep() {}

        /** Pays for the last cycle. */
        double reward(double[] action);

        /** Tells whether there is no sense in going on. */
        boolean isOver();

        /** Gives what is observed besides the perceptors. */
        default double[] extras() {
            return new double[0];
        }
    }
}
