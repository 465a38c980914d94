package org.robonewbie.trial;

import java.util.List;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.simulator.landscape.Thing;

/**
 * What is true at one moment of a trial, without noise and delay; measures look at nothing else. The world frame has its origin
 * on the centre spot, x towards the right goal, y to the left of that and z up.
 *
 * @param seconds simulated time since the trial began
 * @param robots the robots in the order of the scene
 * @param ball centre of the ball, metres
 * @param ballVelocity metres per second
 * @param things what else stands on the pitch, where it is now
 * @param playMode what the referee has decided
 * @param leftGoals goals of the team that plays towards the right
 * @param rightGoals goals of the other team
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

    /** Copies the lists. */
    public WorldState {
        robots = List.copyOf(robots);
        things = List.copyOf(things);
    }

    /**
     * Creates a moment on a pitch where nothing else stands.
     *
     * @param seconds simulated time since the trial began
     * @param robots the robots in the order of the scene
     * @param ball centre of the ball, metres
     * @param ballVelocity metres per second
     * @param playMode what the referee has decided
     * @param leftGoals goals of the team that plays towards the right
     * @param rightGoals goals of the other team
     */
    public WorldState(
            double seconds,
            List<BodyState> robots,
            Vector3 ball,
            Vector3 ballVelocity,
            PlayMode playMode,
            int leftGoals,
            int rightGoals) {
        this(seconds, robots, ball, ballVelocity, List.of(), playMode, leftGoals, rightGoals);
    }

    /** {@return the first robot} */
    public BodyState robot() {
        return robots.get(0);
    }

    /** {@return where the first robot stands} */
    public Pose2d place() {
        return place(0);
    }

    /**
     * Returns where a robot stands.
     *
     * @param index the robot's index in the scene
     * @return the place of its torso
     */
    public Pose2d place(int index) {
        BodyState body = robots.get(index);
        return new Pose2d(body.position().x(), body.position().y(), body.headingDegrees());
    }

    /**
     * Returns the goals of a team.
     *
     * @param side the half of a team
     * @return the team's goals
     */
    public int goals(TeamSide side) {
        return side == TeamSide.LEFT ? leftGoals : rightGoals;
    }
}
