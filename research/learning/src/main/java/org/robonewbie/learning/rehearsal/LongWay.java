package org.robonewbie.learning.rehearsal;

import org.robonewbie.agent.walk.PolicyWalk;
import org.robonewbie.agent.walk.WalkStyle;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.simulator.soccer.SoccerParameters;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;

/**
 * Rehearsals on the league's pitch, which has room for long ways: an agent on a whole simulator with noise, which has reached the stance by
 * way of a nearby posture and is pushed by a hand. It stands 14 m before the centre line and faces the other half.
 */
public final class LongWay {

    private static final Pose2d FAR_END = new Pose2d(-14, 0, 0);
    private static final Vector3 BALL_ASIDE = new Vector3(0, -9, 0);
    private static final double PUSH_NEWTONS = 3;

    private LongWay() {}

    /**
     * Lets an agent walk as it is told.
     *
     * @param seed chooses noise and disturbances
     * @param type how the robot is built
     * @param style how it walks
     * @return the robot on its feet
     */
    public static Rehearsal walking(long seed, RobotType type, WalkStyle style) {
        return begin(seed, type, new AgentPuppet(style));
    }

    /**
     * Lets an agent run as it has learned. It keeps to the line ahead of where it begins, by what it sees and feels itself.
     *
     * @param seed chooses noise and disturbances
     * @param type how the robot is built
     * @param learned how it runs
     * @param keeping how it keeps to its line
     * @return the robot on its feet
     */
    public static Rehearsal running(long seed, RobotType type, PolicyWalk learned, LineKeeping keeping) {
        return begin(seed, type, new RunnerPuppet(learned, keeping));
    }

    private static Rehearsal begin(long seed, RobotType type, Puppet puppet) {
        RobotStart robot = RobotStart.at(FAR_END).withType(type).after("stand");
        Scene pitch = Scene.of(robot).withParameters(SoccerParameters.league()).withBall(BALL_ASIDE);
        return Rehearsal.served(pitch, seed, puppet).intoStance(seed, PUSH_NEWTONS);
    }
}
