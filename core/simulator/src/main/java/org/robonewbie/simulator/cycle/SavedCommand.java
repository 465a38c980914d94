package org.robonewbie.simulator.cycle;

import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;
import org.robonewbie.protocol.effector.EffectorCommand;

/** Serialisation of queued commands. */
final class SavedCommand {

    private static final int KINDS = 6;

    private SavedCommand() {}

    static void save(EffectorCommand command, StateWriter out) {
        if (command instanceof EffectorCommand.CreateRobot create) {
            out.putInt(0);
            out.putText(create.path());
            out.putAll(create.parameters(), out::putText);
        } else if (command instanceof EffectorCommand.JoinTeam join) {
            out.putInt(1);
            out.putInt(join.number());
            out.putText(join.team());
        } else if (command instanceof EffectorCommand.Beam beam) {
            out.putInt(2);
            save(beam, out);
        } else if (command instanceof EffectorCommand.SetHingeSpeed speed) {
            out.putInt(3);
            out.putText(speed.effectorName());
            out.putDouble(speed.radiansPerSecond());
        } else if (command instanceof EffectorCommand.Say say) {
            out.putInt(4);
            out.putText(say.text());
        } else {
            out.putInt(5);
        }
    }

    static EffectorCommand restore(StateReader in) {
        return switch (in.getIndex(KINDS)) {
            case 0 -> new EffectorCommand.CreateRobot(in.getText(), in.getAll(in::getText));
            case 1 -> new EffectorCommand.JoinTeam(in.getInt(), in.getText());
            case 2 -> restoreBeam(in);
            case 3 -> new EffectorCommand.SetHingeSpeed(in.getText(), in.getDouble());
            case 4 -> new EffectorCommand.Say(in.getText());
            default -> new EffectorCommand.RequestPass();
        };
    }

    static void save(EffectorCommand.Beam beam, StateWriter out) {
        out.putDouble(beam.pose().x());
        out.putDouble(beam.pose().y());
        out.putDouble(beam.pose().degrees());
    }

    static EffectorCommand.Beam restoreBeam(StateReader in) {
        return new EffectorCommand.Beam(new Pose2d(in.getDouble(), in.getDouble(), in.getDouble()));
    }
}
