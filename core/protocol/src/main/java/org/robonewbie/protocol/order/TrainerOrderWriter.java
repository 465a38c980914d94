package org.robonewbie.protocol.order;

import java.util.Optional;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.sexp.SexpWriter;

/** Formats trainer commands as messages to a SimSpark server. A message may contain several commands. */
public final class TrainerOrderWriter {

    private static final int DECIMALS = 6;

    private final SexpWriter out;

    /**
     * Creates a writer.
     *
     * @param message the buffer to which the commands are appended
     */
    public TrainerOrderWriter(MessageBuffer message) {
        out = new SexpWriter(message);
    }

    /**
     * Writes one command.
     *
     * @param order the command
     */
    public void write(Order.Trainer order) {
        if (order instanceof Order.KickOff kickOff) {
            out.text("(kickOff ")
                    .text(kickOff.side().map(TrainerOrderWriter::name).orElse("None"))
                    .text(")");
        } else if (order instanceof Order.ChangePlayMode change) {
            out.text("(playMode ").text(change.playMode().simSparkName()).text(")");
        } else if (order instanceof Order.DropBall) {
            out.text("(dropBall)");
        } else if (order instanceof Order.MoveBall move) {
            out.text("(ball");
            writeVector("pos", move.position());
            writeVector("vel", move.velocity());
            out.text(")");
        } else if (order instanceof Order.SetTime time) {
            out.text("(time ").decimal(time.seconds(), DECIMALS).text(")");
        } else if (order instanceof Order.SetScore score) {
            out.text("(score (left ").integer(score.left());
            out.text(")(right ").integer(score.right()).text("))");
        } else if (order instanceof Order.EndSimulation) {
            out.text("(killsim)");
        } else if (order instanceof Order.RequestFullState) {
            out.text("(reqfullstate)");
        } else {
            writeForRobot(order);
        }
    }

    private void writeForRobot(Order.Trainer order) {
        if (order instanceof Order.MoveRobot move) {
            writePlayer("agent", Optional.of(move.player()));
            writeVector("pos", Optional.of(move.position()));
        } else if (order instanceof Order.MoveAndTurnRobot move) {
            writePlayer("agent", Optional.of(move.player()));
            out.text("(move");
            writeComponents(move.position());
            out.text(" ").decimal(move.degreesFromY(), DECIMALS).text(")");
        } else if (order instanceof Order.RepelSelectedRobot) {
            writePlayer("agent", Optional.empty());
        } else if (order instanceof Order.SelectRobot select) {
            writePlayer("select", Optional.of(select.player()));
        } else if (order instanceof Order.SelectNextRobot) {
            writePlayer("select", Optional.empty());
        } else if (order instanceof Order.SelectNoRobot) {
            out.text("(select(unum -1)");
        } else if (order instanceof Order.KillRobot kill) {
            writePlayer("kill", kill.player());
        } else if (order instanceof Order.RepositionRobot reposition) {
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
