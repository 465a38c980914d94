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

    /** The name of the task, such as {@code Walk}. */
    String name();

    /** How each episode begins. */
    TrialSetting setting();

    /** The joints that an action moves; the others stay as they are. */
    List<Joint> joints();

    /** The angle by which an action of 1 differs from the first posture. */
    double rangeDegrees();

    /** The number of cycles after which an episode ends. */
    int longestCycles();

    /** What is observed besides the perceptors. */
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

        /** Whether the episode has ended. */
        boolean isOver();

        /** The values of what is observed besides the perceptors. */
        default double[] extras() {
            return new double[0];
        }
    }
}
