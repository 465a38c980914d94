package org.robonewbie.examples;

import org.robonewbie.agent.Agent;
import org.robonewbie.agent.Options;
import org.robonewbie.agent.perception.FieldItem;
import org.robonewbie.nao.Joint;

/**
 * A reactive agent: sensor readings are mapped directly to motor commands. The head follows the ball, and the robot raises the
 * arm on the side where it sees another robot.
 *
 * <p>There is no {@code think} here; {@code act} sets the motors before it sends the commands.
 */
public final class Agent_Reactive extends Agent {

    private static final double SPEED = 120; // degrees per second

    /** Creates the agent. */
    public Agent_Reactive() {}

    /**
     * Starts the robot.
     *
     * @param args options such as {@code --headless}; {@code --help} lists them
     */
    public static void main(String[] args) {
        new Agent_Reactive().run(args);
    }

    @Override
    protected Options defaults() {
        return Options.none().withPose(-1, 0, 0);
    }

    @Override
    protected void act() {
        FieldItem ball = fieldView.ball();
        if (ball.ageSeconds() < 1) {
            nao.setJointAngle(Joint.NECK_YAW, limited(ball.bearing(), 100), SPEED);
            nao.setJointAngle(Joint.NECK_PITCH, limited(ball.elevation(), 40), SPEED);
        } else {
            lookAround.look();
        }
        nao.setJointAngle(Joint.LEFT_SHOULDER_PITCH, seesRobot(true) ? 90 : 0, SPEED);
        nao.setJointAngle(Joint.RIGHT_SHOULDER_PITCH, seesRobot(false) ? 90 : 0, SPEED);
        super.act();
    }

    private boolean seesRobot(boolean onTheLeft) {
        return fieldView.players().stream()
                .anyMatch(player -> player.ageSeconds() < 1 && (player.bearing() > 0) == onTheLeft);
    }

    private static double limited(double degrees, double most) {
        return Math.max(-most, Math.min(most, degrees));
    }
}
