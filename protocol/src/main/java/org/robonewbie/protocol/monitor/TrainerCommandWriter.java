package org.robonewbie.protocol.monitor;

import java.util.Optional;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.sexp.SexpWriter;

/** Writes commands for a SimSpark server; several may go into one message. */
public final class TrainerCommandWriter {

    private static final int DECIMALS = 6;

    private final SexpWriter out;

    /**
     * Creates a writer.
     *
     * @param message the message at whose end all commands are written
     */
    public TrainerCommandWriter(MessageBuffer message) {
        out = new SexpWriter(message);
    }

    /**
     * Writes one command.
     *
     * @param command the command
     */
    public void write(TrainerCommand command) {
        if (command instanceof TrainerCommand.KickOff kickOff) {
            out.text("(kickOff ")
                    .text(kickOff.side().map(TrainerCommandWriter::name).orElse("None"))
                    .text(")");
        } else if (command instanceof TrainerCommand.ChangePlayMode change) {
            out.text("(playMode ").text(change.playMode().simSparkName()).text(")");
        } else if (command instanceof TrainerCommand.DropBall) {
            out.text("(dropBall)");
        } else if (command instanceof TrainerCommand.MoveBall move) {
            out.text("(ball");
            writeVector("pos", move.position());
            writeVector("vel", move.velocity());
            out.text(")");
        } else if (command instanceof TrainerCommand.SetTime time) {
            out.text("(time ").decimal(time.seconds(), DECIMALS).text(")");
        } else if (command instanceof TrainerCommand.SetScore score) {
            out.text("(score (left ").integer(score.left());
            out.text(")(right ").integer(score.right()).text("))");
        } else if (command instanceof TrainerCommand.EndSimulation) {
            out.text("(killsim)");
        } else if (command instanceof TrainerCommand.RequestFullState) {
            out.text("(reqfullstate)");
        } else {
            writeForRobot(command);
        }
    }

    private void writeForRobot(TrainerCommand command) {
        if (command instanceof TrainerCommand.MoveRobot move) {
            writePlayer("agent", Optional.of(move.player()));
            writeVector("pos", Optional.of(move.position()));
        } else if (command instanceof TrainerCommand.MoveAndTurnRobot move) {
            writePlayer("agent", Optional.of(move.player()));
            out.text("(move");
            writeComponents(move.position());
            out.text(" ").decimal(move.degreesFromY(), DECIMALS).text(")");
        } else if (command instanceof TrainerCommand.RepelSelectedRobot) {
            writePlayer("agent", Optional.empty());
        } else if (command instanceof TrainerCommand.SelectRobot select) {
            writePlayer("select", Optional.of(select.player()));
        } else if (command instanceof TrainerCommand.SelectNextRobot) {
            writePlayer("select", Optional.empty());
        } else if (command instanceof TrainerCommand.SelectNoRobot) {
            out.text("(select(unum -1)");
        } else if (command instanceof TrainerCommand.KillRobot kill) {
            writePlayer("kill", kill.player());
        } else if (command instanceof TrainerCommand.RepositionRobot reposition) {
            writePlayer("repos", reposition.player());
        }
        out.text(")");
    }

    private void writePlayer(String command, Optional<PlayerNumber> player) {
        out.text("(").text(command);
        player.ifPresent(named -> {
            out.text("(unum ").integer(named.number());
            out.text(")(team ").text(name(named.side())).text(")");
        });
    }

    private void writeVector(String name, Optional<Vector3> vector) {
        vector.ifPresent(present -> {
            out.text("(").text(name);
            writeComponents(present);
            out.text(")");
        });
    }

    private void writeComponents(Vector3 vector) {
        out.text(" ").decimal(vector.x(), DECIMALS);
        out.text(" ").decimal(vector.y(), DECIMALS);
        out.text(" ").decimal(vector.z(), DECIMALS);
    }

    private static String name(TeamSide side) {
        return side == TeamSide.LEFT ? "Left" : "Right";
    }
}
