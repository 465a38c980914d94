package org.robonewbie.examples;

import org.robonewbie.agent.Agent;
import org.robonewbie.agent.Options;
import org.robonewbie.agent.perception.FieldItem;

/**
 * Walks to the ball and stops there. It makes a decision whenever the last motion is over: it turns until the ball is ahead,
 * then walks until it is near.
 *
 * <p>The head scans low enough to see even a ball right in front of the feet.
 */
public class Agent_SimpleWalkToBall extends Agent {

    private static final double AHEAD_DEGREES = 15;
    private static final double NEAR_METRES = 0.47;

    /** Creates the agent. */
    public Agent_SimpleWalkToBall() {}

    /**
     * Starts the robot.
     *
     * @param args options such as {@code --pose -1,0,180}; {@code --help} lists them
     */
    public static void main(String[] args) {
        new Agent_SimpleWalkToBall().run(args);
    }

    @Override
    protected Options defaults() {
        return Options.none().withPose(-1, 0, -90);
    }

    @Override
    protected void think() {
        lookAround.look();
        if (!motions.isFinished()) {
            return;
        }
        FieldItem ball = fieldView.ball();
        if (nao.isFallen()) {
            motions.startGetUp();
        } else if (ball.ageSeconds() > 3) {
            motions.start("turn-left");
        } else if (Math.abs(ball.bearing()) > AHEAD_DEGREES) {
            motions.start(ball.bearing() > 0 ? "turn-left-small" : "turn-right-small");
        } else if (ball.distance() > NEAR_METRES) {
            motions.start("walk-forward");
        } else {
            motions.start("stand");
        }
    }
}
