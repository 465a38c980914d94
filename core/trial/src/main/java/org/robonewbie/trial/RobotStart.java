package org.robonewbie.trial;

import java.util.List;
import java.util.stream.Stream;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.file.ShippedMotions;

/**
 * The initial state of a robot in a {@link Scene}: team, number, robot type, pose, and the motions that bring it into its
 * initial posture.
 *
 * @param team name of its team; the team of the first robot of a scene defends the left goal
 * @param number uniform number, 1 to 11
 * @param type robot type
 * @param place start pose, standing with all joints at 0
 * @param prelude motions that the robot plays before the trial starts, such as one that moves it into its
 *     {@linkplain org.robonewbie.agent.walk.Stance standard stance}
 */
public record RobotStart(String team, int number, RobotType type, Pose2d place, List<Motion> prelude) {

    /** The default team. */
    public static final String TEAM = "Students";

    /** Stores an unmodifiable copy of the list. */
    public RobotStart {
        prelude = List.copyOf(prelude);
    }

    /**
     * Creates the initial state of a robot of type 0, number 1 of the default team, facing the right goal.
     *
     * @param x metres from the centre towards the right goal
     * @param y metres from the centre to the left
     * @return the initial state
     */
    public static RobotStart at(double x, double y) {
        return at(new Pose2d(x, y, 0));
    }

    /**
     * Creates the initial state of a robot of type 0, number 1 of the default team.
     *
     * @param place its pose
     * @return the initial state
     */
    public static RobotStart at(Pose2d place) {
        return new RobotStart(TEAM, 1, RobotType.TYPE_0, place, List.of());
    }

    /**
     * Changes the robot type.
     *
     * @param other the robot type
     * @return a modified copy
     */
    public RobotStart withType(RobotType other) {
        return new RobotStart(team, number, other, place, prelude);
    }

    /**
     * Changes the team and the number.
     *
     * @param newTeam name of the team
     * @param newNumber 1 to 11
     * @return a modified copy
     */
    public RobotStart withTeam(String newTeam, int newNumber) {
        return new RobotStart(newTeam, newNumber, type, place, prelude);
    }

    /**
     * Sets the motions that the robot plays before the trial starts.
     *
     * @param motions the motions in order
     * @return a modified copy
     */
    public RobotStart after(Motion... motions) {
        return new RobotStart(team, number, type, place, List.of(motions));
    }

    /**
     * Sets the built-in motions that the robot plays before the trial starts.
     *
     * @param motions names such as {@code stand}
     * @return a modified copy
     * @throws IllegalArgumentException if a motion does not exist
     */
    public RobotStart after(String... motions) {
        return after(Stream.of(motions).map(ShippedMotions::motion).toArray(Motion[]::new));
    }
}
