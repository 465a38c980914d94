package org.robonewbie.examples;

import org.robonewbie.agent.Options;
import org.robonewbie.nao.Vector3;

/**
 * Takes penalties: gets behind the ball as {@link Agent_BetterSoccer} does, but then kicks it hard.
 *
 * <p>A kick needs patience. The robot stops where the ball lies right before one of its feet, looks once more, and only then
 * plays the motion. Where exactly the ball must lie, the file of the motion says: {@code start: stance, ball 17 to 21 cm ahead}.
 *
 * <p>Start {@link Agent_PenaltyGoalkeeper} in the same simulator. Ideas: choose the corner that the goalkeeper leaves free.
 */
public final class Agent_PenaltyAttacker extends Agent_BetterSoccer {

    private static final double KICK_FORWARD_METRES = 0.19;
    private static final double KICK_ASIDE_METRES = 0.055;
    private static final double GOOD_METRES = 0.02;
    private static final double GOOD_DEGREES = 8;
    private static final double NEAR_METRES = 0.45;
    private static final double SLOW = 0.8;

    /** Creates the agent. */
    public Agent_PenaltyAttacker() {}

    /**
     * Starts the robot.
     *
     * @param args options such as {@code --headless}; {@code --help} lists them
     */
    public static void main(String[] args) {
        new Agent_PenaltyAttacker().run(args);
    }

    @Override
    protected Options defaults() {
        return Options.none().withTeam("Attackers").withNumber(2).withPose(-0.8, 0, 0);
    }

    @Override
    protected void bring(Vector3 ball, Vector3 goal) {
        double turn = Math.toDegrees(Math.atan2(goal.y() - ball.y(), goal.x() - ball.x()));
        double distance = Math.hypot(ball.x(), ball.y());
        if (distance > NEAR_METRES || Math.abs(turn) > 40 || ball.x() < 0.05) {
            super.bring(ball, goal);
            return;
        }
        boolean left = ball.y() > 0;
        double forward = ball.x() - KICK_FORWARD_METRES;
        double aside = ball.y() - (left ? KICK_ASIDE_METRES : -KICK_ASIDE_METRES);
        boolean good =
                Math.abs(forward) < GOOD_METRES && Math.abs(aside) < GOOD_METRES && Math.abs(turn) < GOOD_DEGREES;
        if (!good) {
            walk.towards(SLOW * forward, SLOW * aside, turn);
        } else if (walk.isWalking()) {
            walk.stop();
        } else {
            motions.start(left ? "kick-left" : "kick-right");
        }
    }
}
