package org.robonewbie.trial;

import java.util.List;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.simulator.landscape.Thing;

/**
 * The true state of a trial, without noise or delay; it is the only input to measures. The world frame has its origin at the
 * centre spot, x towards the right goal, y to the left and z up.
 *
 * @param seconds simulated time since the start of the trial
 * @param robots the robots in the order of the scene
 * @param ball centre of the ball in metres
 * @param ballVelocity velocity of the ball in metres per second
 * @param things other objects on the pitch, at their current poses
 * @param playMode the play mode
 * @param leftGoals goals of the left team, which plays towards the right
 * @param rightGoals goals of the right team
 */
public record WorldState(
        double seconds,
        List<BodyState> robots,
        Vector3 ball,
        Vector3 ballVelocity,
        List<Thing> things,
        PlayMode playMode,
        int leftGoals,
        int rightGoals) {

    /** Stores unmodifiable copies of the lists. */
    public WorldState {
        robots = List.copyOf(robots);
        things = List.copyOf(things);
    }

    /** {@return the first robot} */
    public BodyState robot() {
        return robots.get(0);
    }

    /** {@return the pose of the first robot on the ground} */
    public Pose2d place() {
        return place(0);
    }

    /**
     * Returns a robot's pose on the ground.
     *
     * @param index the robot's index in the scene
     * @return position and heading of its torso
     */
    public Pose2d place(int index) {
        BodyState body = robots.get(index);
        return new Pose2d(body.position().x(), body.position().y(), body.headingDegrees());
    }

    /**
     * Returns the number of goals that a team has scored.
     *
     * @param side the side of the team
     * @return the number of goals
     */
    public int goals(TeamSide side) {
        return side == TeamSide.LEFT ? leftGoals : rightGoals;
    }
}
