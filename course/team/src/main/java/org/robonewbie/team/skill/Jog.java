package org.robonewbie.team.skill;

import org.robonewbie.agent.policy.file.PolicyFile;
import org.robonewbie.agent.walk.PolicyWalk;
import org.robonewbie.agent.walk.Walk;
import org.robonewbie.nao.geometry.Translation2d;
import org.robonewbie.team.world.WorldModel;

/**
 * Jogging on long ways with a learned walk, which is half as fast again as the usual one but hardly turns. So the robot walks
 * straight ahead for a moment before it jogs, and it slows down before it turns or arrives.
 */
final class Jog {

    private static final PolicyWalk LEARNED = new PolicyWalk(PolicyFile.shipped("jog"));
    private static final double SPEED = 1.05;
    private static final double SLOW = 0.3;
    private static final double MOST_TURN = 40;
    private static final double TURN = 1.6;
    private static final double STARTS_METRES = 2.5;
    private static final double ENDS_METRES = 1.5;
    private static final double STARTS_DEGREES = 15;
    private static final double ENDS_DEGREES = 40;
    private static final double STRAIGHT_SECONDS = 0.6;
    private static final double SLOWING_SECONDS = 1.2;

    private final Walk walk;
    private boolean jogging;
    private double turnedSeconds;
    private double slowUntil;

    /**
     * Creates the skill.
     *
     * @param walk the walk
     */
    Jog(Walk walk) {
        this.walk = walk;
    }

    /**
     * Jogs if the way allows it.
     *
     * @param world the world model
     * @param next next point of the way in the robot's frame
     * @param metres distance to the end of the way
     * @param free whether no other robot is ahead
     * @return whether the robot jogs or slows down; otherwise it has to walk
     */
    boolean go(WorldModel world, Translation2d next, double metres, boolean free) {
        double now = world.seconds();
        boolean straight = Math.abs(next.degrees()) < (jogging ? ENDS_DEGREES : STARTS_DEGREES);
        boolean may = straight && free && metres > (jogging ? ENDS_METRES : STARTS_METRES);
        if (!straight || !walk.isWalking()) {
            turnedSeconds = now;
        }
        if (jogging && !may && walk.isWalking()) {
            slowUntil = now + SLOWING_SECONDS;
        }
        boolean slowing = now < slowUntil;
        jogging = may && !slowing && (jogging || now - turnedSeconds > STRAIGHT_SECONDS);
        if (jogging || slowing) {
            walk.setPolicy(LEARNED);
            double turn = Math.max(-MOST_TURN, Math.min(MOST_TURN, TURN * next.degrees()));
            walk.towards(jogging ? SPEED : SLOW, 0, turn);
        }
        return jogging || slowing;
    }
}
