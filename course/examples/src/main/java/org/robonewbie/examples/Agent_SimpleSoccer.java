package org.robonewbie.examples;

import org.robonewbie.agent.Agent;
import org.robonewbie.agent.Options;
import org.robonewbie.agent.motion.LookAround;
import org.robonewbie.agent.perception.FieldItem;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.PlayMode;

/**
 * A soccer player with a simple decision tree: find the ball, walk to it, get behind it, and push it into the goal. It plays
 * poorly on purpose, to leave much to improve.
 *
 * <p>The head scans continuously. The field view remembers what the camera has seen, and an object counts as known for the
 * duration of one scan. The robot makes a decision only when the last motion is over and its head points at the ground in
 * front of its feet, because the field view is accurate there.
 *
 * <p>Ideas: the player needs the ball nearly straight ahead, but always turns by the same angle: turn by the required angle;
 * stop less often; kick; walk around the ball instead of side-stepping.
 */
public class Agent_SimpleSoccer extends Agent {

    private static final double STRAIGHT_AHEAD_DEGREES = 2;
    private static final double FAR_METRES = 0.54;
    private static final double MEMORY_SECONDS = LookAround.ROUND_SECONDS + 0.2;
    private static final int MANY_STEPS = 25;

    private int stepsAround;

    /** Creates the agent. */
    public Agent_SimpleSoccer() {}

    /**
     * Starts the robot.
     *
     * @param args options such as {@code --headless}; {@code --help} lists them
     */
    public static void main(String[] args) {
        new Agent_SimpleSoccer().run(args);
    }

    @Override
    protected Options defaults() {
        return Options.none().withPose(-0.5, 0.4, -40);
    }

    @Override
    protected void think() {
        lookAround.look();
        if (hasToGoToStart()) {
            nao.beam(options().pose(nao.getNumber()));
            motions.reset();
        } else if (motions.isFinished() && looksAtFeet()) {
            decide();
        }
    }

    /** Chooses the next motion. */
    protected void decide() {
        FieldItem ball = fieldView.ball();
        if (nao.isFallen()) {
            motions.startGetUp();
        } else if (!isKnown(ball)) {
            motions.start("turn-left");
        } else if (Math.abs(ball.bearing()) > STRAIGHT_AHEAD_DEGREES) {
            motions.start(ball.bearing() > 0 ? "turn-left-small" : "turn-right-small");
        } else if (ball.distance() > FAR_METRES) {
            motions.start("walk-forward");
        } else {
            decideAtTheBall(ball);
        }
    }

    private void decideAtTheBall(FieldItem ball) {
        FieldItem leftPost = fieldView.opponentGoalLeftPost();
        FieldItem rightPost = fieldView.opponentGoalRightPost();
        boolean goalAhead = isKnown(leftPost) && isKnown(rightPost) && leftPost.bearing() > rightPost.bearing();
        if (!goalAhead) {
            goAroundTheBall();
        } else if (leftPost.bearing() <= ball.bearing()) {
            motions.start("side-step-left");
        } else if (rightPost.bearing() >= ball.bearing()) {
            motions.start("side-step-right");
        } else {
            motions.start("walk-forward"); // the ball is between the posts: push it
        }
    }

    /** Side-steps until the goal comes into view; changes direction after many steps, because a goal post may be in the way. */
    private void goAroundTheBall() {
        boolean left = stepsAround / MANY_STEPS % 2 == 0;
        motions.start(left ? "side-step-left" : "side-step-right");
        stepsAround++;
    }

    /**
     * Returns whether the head points straight ahead and down; the field view is inaccurate while the head is both turned and
     * tilted.
     */
    private boolean looksAtFeet() {
        return Math.abs(nao.getJointAngle(Joint.NECK_YAW)) < 10 && nao.getJointAngle(Joint.NECK_PITCH) < -25;
    }

    private boolean isKnown(FieldItem item) {
        return item.ageSeconds() < MEMORY_SECONDS;
    }

    private boolean hasToGoToStart() {
        return nao.getPlayMode() == PlayMode.GOAL_LEFT || nao.getPlayMode() == PlayMode.GOAL_RIGHT;
    }
}
