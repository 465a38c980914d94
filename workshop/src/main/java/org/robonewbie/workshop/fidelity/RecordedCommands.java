package org.robonewbie.workshop.fidelity;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Angles;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.model.Hinge;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.protocol.effector.EffectorCommand.Beam;
import org.robonewbie.protocol.effector.EffectorCommand.SetHingeSpeed;
import org.robonewbie.protocol.effector.EffectorMessageReader;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.simulator.physics.BodyPose;

/** Parser for the commands of a recorded client. */
final class RecordedCommands {

    /** Height in metres of the torso of a robot that has just been beamed. */
    static final double BEAM_HEIGHT = 0.4;

    private static final String HOLD_ALL_JOINTS = "HOLD";
    private static final double SAME_METRES = 1e-4;
    private static final double SAME_DEGREES = 0.01;

    private final EffectorMessageReader reader = new EffectorMessageReader();
    private final MessageBuffer message = new MessageBuffer();
    private final NaoModel model;

    RecordedCommands(NaoModel model) {
        this.model = model;
    }

    /**
     * Parses one reply.
     *
     * @param sent text of the reply
     * @param nextTorso torso pose in the next row, to which a server with noise has actually beamed the robot
     * @return hinge speeds and beams; other commands do not move a robot
     */
    List<EffectorCommand> read(String sent, Optional<BodyPose> nextTorso) {
        List<EffectorCommand> commands = new ArrayList<>();
        if (sent.startsWith(HOLD_ALL_JOINTS)) {
            for (Hinge hinge : model.hinges()) {
                commands.add(new SetHingeSpeed(hinge.effectorName(), 0));
            }
            return commands;
        }
        message.clear();
        message.append(sent);
        reader.read(message, command -> add(command, nextTorso, commands), problem -> {});
        return commands;
    }

    private static void add(EffectorCommand command, Optional<BodyPose> nextTorso, List<EffectorCommand> commands) {
        if (command instanceof SetHingeSpeed speed && Double.isFinite(speed.radiansPerSecond())) {
            commands.add(speed);
        } else if (command instanceof Beam wanted) {
            nextTorso.map(torso -> whereItWent(wanted, torso)).ifPresent(commands::add);
        }
    }

    private static Beam whereItWent(Beam wanted, BodyPose torso) {
        Vector3 place = torso.position();
        double heading = TorsoAngles.yawDegrees(torso.rotation());
        boolean exact = wanted.pose().distance(place) < SAME_METRES
                && Math.abs(Angles.wrap(wanted.pose().degrees() - heading)) < SAME_DEGREES;
        return exact ? wanted : new Beam(new Pose2d(place.x(), place.y(), heading));
    }
}
