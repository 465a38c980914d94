package org.robonewbie.team.skill;

import org.robonewbie.nao.Joint;
import org.robonewbie.nao.geometry.Angles;
import org.robonewbie.nao.geometry.Translation2d;
import org.robonewbie.team.world.WorldModel;

/**
 * Gaze control. The camera sees 60° to each side, so the ball need not be in the centre of the image: the head turns
 * from the ball by a limited angle towards the goal that is closer in bearing, because the goal's posts and flags help
 * to localise the robot. If the ball is lost, the head scans.
 */
public final class Gaze {

    private static final double LOST_SECONDS = 1.2;
    private static final double MAX_YAW = 100;
    private static final double ASIDE_DEGREES = 25;
    private static final double PITCH_DEGREES = -20;
    private static final double SPEED = 250;

    private final Limbs body;

    /**
     * Creates the gaze control.
     *
     * @param body the robot
     */
    public Gaze(Limbs body) {
        this.body = body;
    }

    /**
     * Looks at the ball and a goal, or scans for the ball.
     *
     * @param world the world model
     */
    public void look(WorldModel world) {
        if (world.ownBallAgeSeconds() > LOST_SECONDS && world.ballAgeSeconds() > LOST_SECONDS) {
            body.head().look();
            return;
        }
        double ball = world.ballFromHere().degrees();
        double wanted = ball + Math.max(-ASIDE_DEGREES, Math.min(ASIDE_DEGREES, goalBeside(world, ball)));
        body.nao().setJointAngle(Joint.NECK_YAW, Math.max(-MAX_YAW, Math.min(MAX_YAW, wanted)), SPEED);
        body.nao().setJointAngle(Joint.NECK_PITCH, PITCH_DEGREES, SPEED);
    }

    /**
     * Returns the bearing of a goal relative to the bearing of the ball, in degrees to the left, for the goal with the smaller
     * difference.
     */
    private static double goalBeside(WorldModel world, double ball) {
        double theirs = beside(world.theirGoal(), world, ball);
        double ours = beside(world.ourGoal(), world, ball);
        return Math.abs(theirs) <= Math.abs(ours) ? theirs : ours;
    }

    private static double beside(Translation2d goal, WorldModel world, double ball) {
        return Angles.wrap(goal.seenFrom(world.pose()).degrees() - ball);
    }
}
