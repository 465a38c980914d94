package org.robonewbie.simulator.monitor;

import java.util.List;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.monitor.Environment;
import org.robonewbie.protocol.monitor.MonitorMessageWriter;

/** Sends the latest state to all monitors of a server: changes to those that know the scene, everything to the others. */
final class MonitorBroadcast {

    private final SoccerScene scene;
    private final MonitorMessageWriter writer;

    MonitorBroadcast(Environment environment, SoccerField field, double ballRadius) {
        scene = new SoccerScene(field, ballRadius);
        writer = new MonitorMessageWriter(environment);
    }

    void send(MonitorSnapshot snapshot, boolean fullWanted, List<MonitorConnection> connections) {
        boolean changed = scene.update(snapshot);
        List<MonitorConnection> informed =
                connections.stream().filter(MonitorConnection::isUpToDate).toList();
        if (changed || fullWanted || informed.isEmpty()) {
            MessageBuffer message = writer.writeFull(snapshot.game(), snapshot.fouls(), scene.nodes());
            connections.forEach(connection -> connection.send(message));
        } else {
            sendToNewcomers(snapshot, connections);
            MessageBuffer message = writer.writePartial(snapshot.game(), snapshot.fouls(), scene.nodes());
            informed.forEach(connection -> connection.send(message));
        }
    }

    private void sendToNewcomers(MonitorSnapshot snapshot, List<MonitorConnection> connections) {
        List<MonitorConnection> newcomers = connections.stream()
                .filter(connection -> !connection.isUpToDate() && connection.isReady())
                .toList();
        if (!newcomers.isEmpty()) {
            MessageBuffer message = writer.writeFullForNewcomer(snapshot.game(), scene.nodes());
            newcomers.forEach(connection -> connection.send(message));
        }
    }
}
