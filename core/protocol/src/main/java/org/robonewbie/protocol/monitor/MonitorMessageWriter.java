package org.robonewbie.protocol.monitor;

import java.util.List;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.sexp.SexpWriter;

/**
 * Formats the messages from a server to its monitors, byte for byte like rcssserver3d.
 *
 * <p>The writer tracks the state that was sent to all monitors, so that partial messages contain only changes. All monitors of
 * a server therefore share one writer, and a log has a separate writer.
 */
public final class MonitorMessageWriter {

    private final MessageBuffer buffer = new MessageBuffer(1 << 16);
    private final SceneWriter scene;
    private final GameStateWriter gameState;

    /**
     * Creates a writer.
     *
     * @param environment constants of the match
     */
    public MonitorMessageWriter(Environment environment) {
        SexpWriter out = new SexpWriter(buffer);
        scene = new SceneWriter(out);
        gameState = new GameStateWriter(environment, out);
    }

    /**
     * Writes a full message for all monitors. Later partial messages are relative to it.
     *
     * @param state the state of the match
     * @param fouls all fouls of the match, oldest first; those already sent are omitted
     * @param nodes the scene
     * @return the message, valid until the next message is written
     */
    public MessageBuffer writeFull(MonitoredGame state, List<Foul> fouls, List<? extends SceneNode> nodes) {
        return writeFull(state, fouls, nodes, true);
    }

    /**
     * Writes a full message for a newly connected monitor, without affecting later partial messages to all monitors.
     *
     * @param state the state of the match
     * @param nodes the scene
     * @return the message, valid until the next message is written
     */
    public MessageBuffer writeFullForNewcomer(MonitoredGame state, List<? extends SceneNode> nodes) {
        return writeFull(state, List.of(), nodes, false);
    }

    /**
     * Writes a partial message with the changes since the last message.
     *
     * @param state the state of the match
     * @param fouls all fouls of the match, oldest first; those already sent are omitted
     * @param nodes the scene, with the same structure as in the last full message
     * @return the message, valid until the next message is written
     */
    public MessageBuffer writePartial(MonitoredGame state, List<Foul> fouls, List<? extends SceneNode> nodes) {
        buffer.clear();
        gameState.writePartial(state, fouls);
        buffer.append("(RDS 0 1)");
        scene.writePartial(nodes);
        return buffer;
    }

    private MessageBuffer writeFull(
            MonitoredGame state, List<Foul> fouls, List<? extends SceneNode> nodes, boolean toAll) {
        buffer.clear();
        gameState.writeFull(state, fouls, toAll);
        buffer.append("(RSG 0 1)");
        scene.writeFull(nodes, toAll);
        return buffer;
    }
}
