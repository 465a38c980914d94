package org.robonewbie.team.skill;

import org.robonewbie.nao.Joint;
import org.robonewbie.nao.geometry.Angles;
import org.robonewbie.nao.geometry.Translation2d;
import org.robonewbie.team.world.WorldModel;

/**
 * Where the robot looks. The camera sees 60° to each side, so the ball need not be in the middle of the picture: the head turns from
 * the ball towards the nearer goal, where posts and flags show the robot where it is. A ball that is lost is looked for by turning.
 */
public final class Gaze {

    private static final double LOST_SECONDS = 1.2;
    private static final double MAX_YAW = 100;
    private static final double ASIDE_DEGREES = 25;
    private static final double PITCH_DEGREES = -20;
    private static final double SPEED = 250;

    private final Limbs body;

    /**
     * Prepares the head.
     *
     * @param body has a head
     */
    public Gaze(Limbs body) {
        this.body = body;
    }

    /**
     * Looks at ball and goals, or around.
     *
     * @param world where they should be
     */
    public void look(WorldModel world) {
        if (world.ownBallAgeSeconds() > LOST_SECONDS && world.ballAgeSeconds() > LOST_SECONDS) {
            body.head().look();
            return;
        }
        double ball = world.ballFromHere().degrees();
        double wanted = ball + Math.max(-ASIDE_DEGREES, Math.min(ASIDE_DEGREES, landmarks(world, ball)));
        body.nao().setJointAngle(Joint.NECK_YAW, Math.max(-MAX_YAW, Math.min(MAX_YAW, wanted)), SPEED);
        body.nao().setJointAngle(Joint.NECK_PITCH, PITCH_DEGREES, SPEED);
    }

    /** How far beside the ball the goal is that is nearer to the ball, degrees to the left. */
    private static double landmarks(WorldModel world, double ball) {
        double theirs = beside(world.theirGoal(), world, ball);
        double ours = beside(world.ourGoal(), world, ball);
        return Math.abs(theirs) <= Math.abs(ours) ? theirs : ours;
    }

    private static double beside(Translation2d goal, WorldModel world, double ball) {
        return Angles.wrap(goal.seenFrom(world.pose()).degrees() - ball);
    }
}
