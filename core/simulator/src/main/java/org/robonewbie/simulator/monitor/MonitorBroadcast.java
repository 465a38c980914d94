package org.robonewbie.simulator.monitor;

import java.util.List;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.monitor.MonitorMessageWriter;
import org.robonewbie.simulator.soccer.SoccerParameters;

/** Sends states to all monitors: partial messages to those that are up to date, full messages to the others. */
final class MonitorBroadcast {

    private final SoccerScene scene;
    private final MonitorMessageWriter writer;

    MonitorBroadcast(SoccerParameters parameters) {
        scene = new SoccerScene(parameters);
        writer = new MonitorMessageWriter(MatchEnvironment.of(parameters));
    }

    void send(MonitorSnapshot snapshot, boolean fullWanted, List<MonitorConnection> connections) {
        boolean changed = scene.update(snapshot);
        List<MonitorConnection> upToDate =
                connections.stream().filter(MonitorConnection::isUpToDate).toList();
        if (changed || fullWanted || upToDate.isEmpty()) {
            MessageBuffer message = writer.writeFull(snapshot.game(), snapshot.fouls(), scene.nodes());
            connections.forEach(connection -> connection.send(message));
        } else {
            sendToNewcomers(snapshot, connections);
            MessageBuffer message = writer.writePartial(snapshot.game(), snapshot.fouls(), scene.nodes());
            upToDate.forEach(connection -> connection.send(message));
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
