package org.robonewbie.examples;

import org.robonewbie.agent.Agent;
import org.robonewbie.agent.Options;
import org.robonewbie.agent.perception.CameraPicture;
import org.robonewbie.agent.perception.CameraTransformation;
import org.robonewbie.agent.perception.Direction;
import org.robonewbie.agent.perception.FieldItem;
import org.robonewbie.agent.perception.LineItem;
import org.robonewbie.agent.perception.PlayerItem;
import org.robonewbie.nao.BodyPart;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Landmark;
import org.robonewbie.nao.Vector3;

/**
 * Logs the contents of the field view while the head scans, twice per second for five seconds, and compares them with the true
 * positions.
 *
 * <p>Watch how objects remain known when the head turns away, and how their age increases. Start {@link Agent_Dummy} in the
 * same simulator to see another robot.
 *
 * <p>The true positions are not available to a real robot; the simulator sends them for this experiment (option {@code
 * --truth}). The field view adds the angles of the neck and the camera, which is a simple approximation. How large is the
 * error, and at which head angles is it largest? With the argument {@code exact}, the robot uses the forward kinematics of its
 * neck.
 */
public final class Agent_TestLocalFieldView extends Agent {

    private int cycle;
    private int comparisons;
    private double sumOfErrors;
    private double largestError;

    /** Creates the agent. */
    public Agent_TestLocalFieldView() {}

    /**
     * Starts the robot.
     *
     * @param args {@code exact} for exact kinematics, and options such as {@code --headless}
     */
    public static void main(String[] args) {
        new Agent_TestLocalFieldView().run(args);
    }

    @Override
    protected Options defaults() {
        return Options.none()
                .withWords()
                .withTeam("teamA")
                .withPose(-1, 0.7, -60)
                .withSeconds(5)
                .with("truth", "true");
    }

    @Override
    protected void think() {
        if (options().arguments().contains("exact")) {
            fieldView.setTransformation(CameraTransformation.KINEMATICS);
        }
        lookAround.look();
        nao.getVision().flatMap(CameraPicture::truth).ifPresent(this::compare);
        if (cycle++ % 25 == 0) {
            logView();
        }
    }

    /** Compares the estimated position of the ball with the true one whenever the ball is visible. */
    private void compare(CameraPicture.Truth places) {
        FieldItem ball = fieldView.ball();
        if (ball.isVisible()) {
            Vector3 truth = seenFromHead(
                    places.ball(), places.head(), places.headDegrees() - nao.getJointAngle(Joint.NECK_YAW));
            double error = ball.position().distanceTo(truth);
            comparisons++;
            sumOfErrors += error;
            largestError = Math.max(largestError, error);
            nao.plot("ball error in metres", error);
            nao.drawPoint(truth, "green");
            nao.drawPoint(ball.position(), "orange");
            if (cycle % 25 == 0) {
                log.info("true ball %s; the estimate is %.3f m off", Direction.of(truth), error);
                log.info("mean error %.3f m, largest %.3f m", sumOfErrors / comparisons, largestError);
            }
        }
    }

    /** Converts a point on the field to the frame of a head that is facing straight ahead. */
    private static Vector3 seenFromHead(Vector3 point, Vector3 head, double headingDegrees) {
        Vector3 way = point.minus(head);
        double heading = Math.toRadians(headingDegrees);
        return new Vector3(
                way.x() * Math.cos(heading) + way.y() * Math.sin(heading),
                way.y() * Math.cos(heading) - way.x() * Math.sin(heading),
                way.z());
    }

    private void logView() {
        log.info("%s%s", fieldView.ball(), fieldView.ball().isVisible() ? ", visible now" : "");
        for (Landmark landmark : Landmark.values()) {
            log.info("%s", fieldView.landmark(landmark));
        }
        for (PlayerItem player : fieldView.players()) {
            log.info("%s; %s", player, player.part(BodyPart.HEAD));
        }
        for (LineItem line : fieldView.lines()) {
            log.info("line from %s to %s", line.start(), line.end());
        }
    }
}
