package org.robonewbie.examples;

import java.util.Locale;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.Options;
import org.robonewbie.agent.perception.CameraPicture;
import org.robonewbie.agent.perception.HeardMessage;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;

/**
 * Logs all sensor readings in each of 50 cycles. The log is printed after the run, because printing during a cycle would take
 * too long.
 *
 * <p>Start {@link Agent_Dummy} in the same simulator to receive messages and to have a robot in view.
 */
public final class Agent_TestPerceptorInput extends Agent {

    /** Creates the agent. */
    public Agent_TestPerceptorInput() {}

    /**
     * Starts the robot.
     *
     * @param args options such as {@code --headless}; {@code --help} lists them
     */
    public static void main(String[] args) {
        new Agent_TestPerceptorInput().run(args);
    }

    @Override
    protected Options defaults() {
        return Options.none().withTeam("teamA").withPose(-0.5, 1, -90).withSeconds(1);
    }

    @Override
    protected void think() {
        nao.say("listen-to-me");
        log.info("message: %s", nao.getRawMessage());
        log.info(
                "game: %s at %.2f s, %d : %d",
                nao.getPlayMode(), nao.getPlayTime(), nao.getOwnScore(), nao.getOpponentScore());
        log.info("me: number %d of %s, side %s", nao.getNumber(), nao.getTeam(), nao.getTeamSide());
        logJoints();
        logVector("gyro (degrees per second)", nao.getGyro());
        logVector("acceleration (m/s2)", nao.getAcceleration());
        logVector("force on the left foot (newton)", nao.getLeftFootPressure().force());
        logVector("force on the right foot (newton)", nao.getRightFootPressure().force());
        log.info("body: %s", nao.getBodyPosition());
        for (HeardMessage heard : nao.getHeard()) {
            log.info("heard: %s", heard);
        }
        nao.getVision().ifPresent(this::logPicture);
    }

    private void logPicture(CameraPicture picture) {
        for (CameraPicture.Sighting sighting : picture.sightings()) {
            log.info("camera: %s at %s", sighting.name(), sighting.direction());
        }
    }

    private void logVector(String name, Vector3 vector) {
        log.info("%s: %.2f forward, %.2f left, %.2f up", name, vector.x(), vector.y(), vector.z());
    }

    private void logJoints() {
        StringBuilder angles = new StringBuilder("joints (degrees):");
        for (Joint joint : Joint.values()) {
            angles.append(String.format(Locale.ROOT, " %s %.1f", joint, nao.getJointAngle(joint)));
        }
        log.info(angles.toString());
    }
}
