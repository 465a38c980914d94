package org.robonewbie.simulator.fidelity;

import java.util.Optional;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.protocol.effector.EffectorMessageReader;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.simulator.physics.Pose;
import org.robonewbie.simulator.world.Robot;

/** Does to a robot what a recorded client asked for. */
final class RecordedAnswer {

    private static final String HOLD_ALL_JOINTS = "HOLD";
    private static final double BEAM_HEIGHT = 0.4;

    private final EffectorMessageReader reader = new EffectorMessageReader();
    private final MessageBuffer message = new MessageBuffer();
    private final Robot robot;

    RecordedAnswer(Robot robot) {
        this.robot = robot;
    }

    /**
     * Applies one answer.
     *
     * @param sent the text that the client sent
     * @param nextTorso where the torso was one row later: a server with noise beams a robot somewhere near
     */
    void apply(String sent, Optional<Pose> nextTorso) {
        if (sent.equals(HOLD_ALL_JOINTS)) {
            holdAllJoints();
            return;
        }
        message.clear();
        message.append(sent);
        reader.read(message, command -> apply(command, nextTorso), problem -> {});
    }

    private void apply(EffectorCommand command, Optional<Pose> nextTorso) {
        if (command instanceof EffectorCommand.SetHingeSpeed speed) {
            setSpeed(speed);
        } else if (command instanceof EffectorCommand.Beam) {
            nextTorso.ifPresent(this::beamTo);
        }
    }

    private void setSpeed(EffectorCommand.SetHingeSpeed command) {
        for (int i = 0; i < robot.model().hinges().size(); i++) {
            if (robot.model().hinges().get(i).effectorName().equals(command.effectorName())) {
                robot.setMotorSpeed(i, command.radiansPerSecond());
            }
        }
    }

    private void holdAllJoints() {
        for (int i = 0; i < robot.model().hinges().size(); i++) {
            robot.setMotorSpeed(i, 0);
        }
    }

    private void beamTo(Pose torso) {
        Vector3 place = torso.position();
        robot.beam(new Vector3(place.x(), place.y(), BEAM_HEIGHT), TorsoAngles.yawDegrees(torso.rotation()) - 90);
    }
}
