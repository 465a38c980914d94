package org.robonewbie.exercises;

import java.util.List;
import java.util.Optional;

/**
 * Three levels that take a newcomer about a minute each, before the first exercise. A level is an exercise without a
 * worksheet or number; students may see its solution at any time.
 */
public final class FirstMinute {

    private static final List<Exercise> LEVELS = List.of(
            new Exercise(
                    0,
                    "wave",
                    "Wave",
                    "Make the robot wave",
                    1,
                    "The left arm points forward, at 0 degrees. Raise it: change the 0 to 90.",
                    6,
                    WaveTask::new),
            new Exercise(
                    0,
                    "look-at-ball",
                    "LookAtBall",
                    "Make it look at the ball",
                    1,
                    "The ball rolls past, but the head does not move. Add one line that turns it to the ball.",
                    6,
                    LookAtBallTask::new),
            new Exercise(
                    0,
                    "walk-and-kick",
                    "WalkAndKick",
                    "Make it walk to the ball and kick",
                    1,
                    "The ball is 1 m away. Add three lines: walk there, stop, kick.",
                    20,
                    WalkAndKickTask::new));

    private FirstMinute() {}

    /** {@return the levels in playing order} */
    public static List<Exercise> levels() {
        return LEVELS;
    }

    /**
     * Finds a level.
     *
     * @param name name of the level, such as {@code wave}
     * @return the level; empty if there is no such level
     */
    public static Optional<Exercise> find(String name) {
        return LEVELS.stream().filter(level -> level.name().equals(name)).findFirst();
    }

    /**
     * Returns the program that solves a level. It differs from the {@linkplain Exercise#startCode() starter code} only in the lines that
     * the newcomer changes, and has the same number of lines.
     *
     * @param level the level
     * @return source of a Java file
     */
    public static String solution(Exercise level) {
        return Exercise.text("start/solved/" + level.className() + ".java.txt");
    }
}
