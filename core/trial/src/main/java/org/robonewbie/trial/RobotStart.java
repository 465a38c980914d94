package org.robonewbie.trial;

import java.util.List;
import java.util.stream.Stream;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.file.ShippedMotions;

/**
 * How one robot of a {@link Scene} starts: its team, its number, its build, its place, and how it gets into its first posture.
 *
 * @param team its team; the team of a scene's first robot owns the left goal
 * @param number its number, 1 to 11
 * @param type its build
 * @param place where it starts, standing with all joints at 0
 * @param prelude motions that it plays before the trial begins, such as one into the stance
 */
public record RobotStart(String team, int number, RobotType type, Pose2d place, List<Motion> prelude) {

    /** The team of robots that are alone on the pitch. */
    public static final String TEAM = "Students";

    /** Copies the list. */
    public RobotStart {
        prelude = List.copyOf(prelude);
    }

    /**
     * Places a standard robot, number 1 of its team, facing the right goal.
     *
     * @param x metres from the centre towards the right goal
     * @param y metres from the centre to the left
     * @return the start
     */
    public static RobotStart at(double x, double y) {
        return at(new Pose2d(x, y, 0));
    }

    /**
     * Places a standard robot, number 1 of its team.
     *
     * @param place where it stands
     * @return the start
     */
    public static RobotStart at(Pose2d place) {
        return new RobotStart(TEAM, 1, RobotType.TYPE_0, place, List.of());
    }

    /**
     * Chooses another place.
     *
     * @param other where the robot stands
     * @return a changed copy
     */
    public RobotStart withPlace(Pose2d other) {
        return new RobotStart(team, number, type, other, prelude);
    }

    /**
     * Chooses another build.
     *
     * @param other the robot type
     * @return a changed copy
     */
    public RobotStart withType(RobotType other) {
        return new RobotStart(team, number, other, place, prelude);
    }

    /**
     * Chooses another team and number.
     *
     * @param newTeam name of the team
     * @param newNumber 1 to 11
     * @return a changed copy
     */
    public RobotStart withTeam(String newTeam, int newNumber) {
        return new RobotStart(newTeam, newNumber, type, place, prelude);
    }

    /**
     * Plays motions before the trial begins.
     *
     * @param motions the motions in order
     * @return a changed copy
     */
    public RobotStart after(Motion... motions) {
        return new RobotStart(team, number, type, place, List.of(motions));
    }

    /**
     * Plays motions of the framework before the trial begins.
     *
     * @param motions names such as {@code stand}
     * @return a changed copy
     * @throws IllegalArgumentException if there is no motion of a name
     */
    public RobotStart after(String... motions) {
        return after(Stream.of(motions).map(ShippedMotions::motion).toArray(Motion[]::new));
    }
}
