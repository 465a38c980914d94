package org.robonewbie.protocol.monitor;

import java.util.List;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.sexp.SexpWriter;

/**
 * Writes the messages of a server to its monitors, byte for byte as rcssserver3d does.
 *
 * <p>It remembers what all monitors know, so that only changes need to be sent. One writer therefore serves all monitors of a
 * server, and a log has its own.
 */
public final class MonitorMessageWriter {

    private final MessageBuffer buffer = new MessageBuffer(1 << 16);
    private final SceneWriter scene;
    private final GameStateWriter gameState;

    /**
     * Creates a writer that has sent nothing yet.
     *
     * @param environment what stays constant during the match
     */
    public MonitorMessageWriter(Environment environment) {
        SexpWriter out = new SexpWriter(buffer);
        scene = new SceneWriter(out);
        gameState = new GameStateWriter(environment, out);
    }

    /**
     * Writes everything, for all monitors, and from then on treats it as known.
     *
     * @param state the state of the match
     * @param fouls fouls of the match in order; those sent before are omitted
     * @param nodes the scene
     * @return the message; it changes with the next one
     */
    public MessageBuffer writeFull(MonitoredGame state, List<Foul> fouls, List<? extends SceneNode> nodes) {
        return writeFull(state, fouls, nodes, true);
    }

    /**
     * Writes everything, for a monitor that has just connected while others know it already.
     *
     * @param state the state of the match
     * @param nodes the scene
     * @return the message; it changes with the next one
     */
    public MessageBuffer writeFullForNewcomer(MonitoredGame state, List<? extends SceneNode> nodes) {
        return writeFull(state, List.of(), nodes, false);
    }

    /**
     * Writes what has changed.
     *
     * @param state the state of the match
     * @param fouls fouls of the match in order; those sent before are omitted
     * @param nodes the scene, which must have the same structure as in the last full message
     * @return the message; it changes with the next one
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
