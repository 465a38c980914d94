package org.robonewbie.simulator.monitor;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.zip.GZIPInputStream;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.monitor.MonitoredRobot;
import org.robonewbie.protocol.monitor.MonitoredWorld;
import org.robonewbie.protocol.monitor.TransformNode;

/** What a real rcssserver3d 0.7.3 sent to a monitor: a full message, 50 changes, and one more full message among them. */
final class RecordedMonitorMessages {

    private static final String RESOURCE = "/org/robonewbie/protocol/monitor/g_monitor_first_and_50_updates.txt.gz";

    private RecordedMonitorMessages() {}

    static List<String> load() {
        try (BufferedReader reader = new BufferedReader(new InputStreamReader(
                new GZIPInputStream(
                        Objects.requireNonNull(RecordedMonitorMessages.class.getResourceAsStream(RESOURCE))),
                StandardCharsets.US_ASCII))) {
            return reader.lines().filter(line -> line.startsWith("(")).toList();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    static MessageBuffer message(String text) {
        MessageBuffer message = new MessageBuffer();
        message.append(text);
        return message;
    }

    /** Turns what was read from a recording into what our server would tell. */
    static MonitorSnapshot snapshot(MonitoredWorld world) {
        List<MonitoredRobotState> robots =
                world.robots().stream().map(RecordedMonitorMessages::state).toList();
        return new MonitorSnapshot(
                world.gameState(),
                world.newFouls(),
                transforms(List.of(world.ball().orElseThrow())),
                List.of(),
                robots);
    }

    private static MonitoredRobotState state(MonitoredRobot robot) {
        List<TransformNode> links = NaoModel.of(robot.type()).links().stream()
                .map(link -> robot.link(link.name()).orElseThrow())
                .toList();
        return new MonitoredRobotState(1, robot.type(), Optional.of(robot.player()), false, transforms(links));
    }

    private static float[] transforms(List<TransformNode> nodes) {
        float[] transforms = new float[16 * nodes.size()];
        for (int i = 0; i < transforms.length; i++) {
            transforms[i] = nodes.get(i / 16).element(i % 16);
        }
        return transforms;
    }
}
