package org.robonewbie.simulator.monitor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.DataInputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.Socket;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.monitor.MonitoredWorld;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.protocol.order.PlayerNumber;
import org.robonewbie.protocol.tcp.MonitorLink;

@Timeout(120)
class MonitorPortTest {

    private static final PlayerNumber FIRST = new PlayerNumber(TeamSide.LEFT, 1);

    @SuppressWarnings("NullAway.Init")
    private WatchedWorld watched;

    @BeforeEach
    void open() throws IOException {
        watched = new WatchedWorld();
    }

    @AfterEach
    void close() {
        watched.close();
    }

    @Test
    void monitorGetsTheWholeSceneUnaskedAndThenChanges() throws Exception {
        watched.addRobot();
        try (MonitorLink monitor = watched.connect()) {
            watched.runCycles(10);

            assertThat(nextText(monitor)).contains("(RSG 0 1)").contains("matNum1 matLeft");
            for (int i = 0; i < 4; i++) {
                assertThat(nextText(monitor)).startsWith("((time ").contains("(RDS 0 1)");
            }
            assertThat(monitor.world().isCurrent()).isTrue();
        }
    }

    @Test
    void oneMessageComesEachMonitorStep() throws Exception {
        try (MonitorLink monitor = watched.connect()) {
            watched.runCycles(101);

            List<Double> times = new ArrayList<>();
            for (int i = 0; i < 51; i++) {
                assertThat(monitor.receive()).isTrue();
                times.add(monitor.world().gameState().timeSeconds());
            }
            for (int i = 1; i < times.size(); i++) {
                assertThat(times.get(i) - times.get(i - 1)).isCloseTo(0.04, within(1e-6));
            }
        }
    }

    @Test
    void monitorSeesBallAndRobotWhereTheyTrulyAre() throws Exception {
        var robot = watched.addRobot();
        watched.world().ball().place(new Vector3(2, -1, 0.042));
        watched.world().ball().setVelocity(new Vector3(3, 1, 2));
        try (MonitorLink monitor = watched.connect()) {
            watched.runCycles(41);
            for (int i = 0; i < 21; i++) {
                assertThat(monitor.receive()).isTrue();
            }

            MonitoredWorld seen = monitor.world();
            Vector3 torso =
                    seen.robot(FIRST).orElseThrow().link("body").orElseThrow().position();
            assertThat(seen.ball()
                            .orElseThrow()
                            .position()
                            .distanceTo(watched.world().ball().position()))
                    .isLessThan(0.009);
            assertThat(torso.distanceTo(robot.torso().position())).isLessThan(0.009);
        }
    }

    @Test
    void allMonitorsGetEverythingWhenARobotComes() throws Exception {
        try (MonitorLink first = watched.connect();
                MonitorLink second = watched.connect()) {
            watched.runCycles(1);
            assertThat(nextText(first)).contains("(RSG ");
            assertThat(nextText(second)).contains("(RSG ");

            watched.addRobot();
            watched.runCycles(2);

            assertThat(nextText(first)).contains("(RSG ").contains("naobody0");
            assertThat(nextText(second)).contains("(RSG ").contains("naobody0");
        }
    }

    @Test
    void lateMonitorGetsEverythingWhileTheOthersGetChanges() throws Exception {
        try (MonitorLink first = watched.connect()) {
            watched.runCycles(1);
            assertThat(nextText(first)).contains("(RSG ");
            try (MonitorLink late = watched.connect()) {
                watched.runCycles(2);

                assertThat(nextText(late)).contains("(RSG ");
                assertThat(nextText(first)).contains("(RDS ");
            }
        }
    }

    @Test
    void requestedFullStateGoesToAll() throws Exception {
        try (MonitorLink first = watched.connect();
                MonitorLink second = watched.connect()) {
            watched.runCycles(1);
            nextText(first);
            nextText(second);

            watched.port().requestFullState();
            watched.runCycles(4);

            assertThat(nextText(first)).contains("(RSG ");
            assertThat(nextText(second)).contains("(RSG ");
            assertThat(nextText(first)).contains("(RDS ");
        }
    }

    @Test
    void nothingIsComposedWhileNobodyWatches() {
        watched.port().cycleEnded(0, () -> {
            throw new AssertionError("A snapshot was taken for nobody");
        });
        assertThat(watched.console()).isEmpty();
    }

    @Test
    void frozenMonitorHoldsUpNobodyAndFindsWholeMessagesLater() throws Exception {
        for (int i = 0; i < 22; i++) {
            watched.addRobot();
        }
        try (Socket frozen =
                new Socket(InetAddress.getLoopbackAddress(), watched.port().number())) {
            watched.awaitMonitors(1);
            try (MonitorLink healthy = watched.connect()) {
                for (int i = 0; i < 400; i++) {
                    watched.jump();
                    assertThat(healthy.receive()).isTrue();
                    assertThat(healthy.world().isCurrent()).isTrue();
                }
            }

            DataInputStream thawed = new DataInputStream(frozen.getInputStream());
            MonitoredWorld seen = new MonitoredWorld();
            int fullMessages = 0;
            for (int i = 0; i < 1000 && fullMessages < 2; i++) {
                watched.jump();
                MessageBuffer message = readFrame(thawed);
                assertThat(seen.read(message)).as("message " + i).isTrue();
                fullMessages += message.toString().contains("(RSG ") ? 1 : 0;
            }
            assertThat(fullMessages).as("first message, and one after the gap").isEqualTo(2);
        }
    }

    @Test
    void commandsOfATrainerThatNeverReadsArrive() throws Exception {
        for (int i = 0; i < 22; i++) {
            watched.addRobot();
        }
        try (Socket mute =
                new Socket(InetAddress.getLoopbackAddress(), watched.port().number())) {
            watched.awaitMonitors(1);
            for (int i = 0; i < 300; i++) {
                watched.jump();
                send(mute, "(ball (pos " + i + " 0 0) (vel 0 0 0))");
                assertThat(((Order.MoveBall) watched.nextOrder())
                                .position()
                                .orElseThrow()
                                .x())
                        .isEqualTo(i);
            }
        }
    }

    @Test
    void commandsArriveInOrder() throws Exception {
        try (MonitorLink monitor = watched.connect()) {
            monitor.send(new Order.DropBall(), new Order.SetTime(3));
            monitor.send(new Order.KillRobot(Optional.of(FIRST)));

            assertThat(watched.nextOrder()).isEqualTo(new Order.DropBall());
            assertThat(watched.nextOrder()).isEqualTo(new Order.SetTime(3));
            assertThat(watched.nextOrder()).isEqualTo(new Order.KillRobot(Optional.of(FIRST)));
        }
    }

    @Test
    void commandThatComesInPiecesIsUnderstood() throws Exception {
        try (Socket socket =
                new Socket(InetAddress.getLoopbackAddress(), watched.port().number())) {
            watched.awaitMonitors(1);
            byte[] frame = frame("(dropBall)");
            for (byte part : frame) {
                socket.getOutputStream().write(part);
                socket.getOutputStream().flush();
            }

            assertThat(watched.nextOrder()).isEqualTo(new Order.DropBall());
        }
    }

    @Test
    void garbageHarmsOnlyWhoSendsIt() throws Exception {
        Random random = new Random(5);
        try (MonitorLink healthy = watched.connect()) {
            for (int i = 0; i < 20; i++) {
                try (Socket socket = new Socket(
                        InetAddress.getLoopbackAddress(), watched.port().number())) {
                    byte[] garbage = new byte[1 + random.nextInt(3000)];
                    random.nextBytes(garbage);
                    garbage[0] = (byte) (i % 2 == 0 ? 0xFF : 0);
                    socket.getOutputStream().write(garbage);
                    socket.shutdownOutput();
                    assertThat(socket.getInputStream().read()).isEqualTo(-1);
                }
            }
            healthy.send(new Order.DropBall());
            watched.runCycles(1);

            assertThat(watched.nextOrder()).isEqualTo(new Order.DropBall());
            assertThat(nextText(healthy)).contains("(RSG ");
        }
    }

    @Test
    void thousandsOfShortConnectionsLeaveNothingBehind() throws Exception {
        try (MonitorLink healthy = watched.connect()) {
            for (int i = 0; i < 10_000; i++) {
                try (Socket socket = new Socket(
                        InetAddress.getLoopbackAddress(), watched.port().number())) {
                    socket.setSoLinger(i % 2 == 0, 0);
                    if (i % 100 == 99) {
                        awaitFarewell(socket);
                    }
                }
            }
            try (MonitorLink late =
                    MonitorLink.connect("127.0.0.1", watched.port().number())) {
                late.send(new Order.DropBall());
                assertThat(watched.nextOrder()).isEqualTo(new Order.DropBall());
                watched.awaitMonitors(2);
                watched.runCycles(1);

                assertThat(nextText(healthy)).contains("(RSG ");
                assertThat(nextText(late)).contains("(RSG ");
                assertThat(watched.console()).isEmpty();
            }
        }
    }

    /** Leaves and waits until the port has noticed, so that a slow machine never holds more connections than it may. */
    private static void awaitFarewell(Socket socket) throws IOException {
        socket.shutdownOutput();
        socket.getInputStream().readAllBytes();
    }

    @Test
    void announcedMessageOfFourGibibytesEndsTheConnectionWithAWord() throws Exception {
        try (Socket socket =
                new Socket(InetAddress.getLoopbackAddress(), watched.port().number())) {
            watched.awaitMonitors(1);
            socket.getOutputStream().write(new byte[] {-1, -1, -1, -1, '('});

            assertThat(socket.getInputStream().read()).isEqualTo(-1);
            assertThat(watched.console())
                    .singleElement()
                    .asString()
                    .contains("A monitor was disconnected")
                    .contains("4294967295");
        }
    }

    @Test
    void moreThanFiveHundredMonitorsAreRefusedWithAWord() throws Exception {
        List<Socket> sockets = new ArrayList<>();
        try {
            for (int i = 0; i < 500; i++) {
                sockets.add(new Socket(
                        InetAddress.getLoopbackAddress(), watched.port().number()));
                watched.awaitMonitors(i + 1);
            }
            Socket refused =
                    new Socket(InetAddress.getLoopbackAddress(), watched.port().number());
            sockets.add(refused);

            assertThat(refused.getInputStream().read()).isEqualTo(-1);
            assertThat(watched.console()).containsExactly("A monitor was refused because 500 are already connected.");
        } finally {
            for (Socket socket : sockets) {
                socket.close();
            }
        }
    }

    @Test
    void portInUseIsToldWithWhatToDo() {
        int taken = watched.port().number();

        assertThatThrownBy(() -> MonitorPort.open(WatchedWorld.settings(taken), text -> {}, command -> {}))
                .isInstanceOf(IOException.class)
                .hasMessageContaining("Monitor port " + taken + " on 127.0.0.1 cannot be opened")
                .hasMessageContaining("choose another port with --monitor-port");
    }

    @Test
    void closedPortEndsTheConnections() throws Exception {
        try (MonitorLink monitor = watched.connect()) {
            watched.close();

            assertThat(monitor.receive()).isFalse();
        }
    }

    private static MessageBuffer readFrame(DataInputStream in) throws IOException {
        MessageBuffer message = new MessageBuffer();
        message.resize(in.readInt());
        in.readFully(message.bytes(), 0, message.length());
        return message;
    }

    private static String nextText(MonitorLink monitor) throws IOException {
        assertThat(monitor.receive()).isTrue();
        return monitor.lastMessage().toString();
    }

    private static void send(Socket socket, String text) throws IOException {
        OutputStream out = socket.getOutputStream();
        out.write(frame(text));
        out.flush();
    }

    private static byte[] frame(String text) {
        byte[] frame = new byte[4 + text.length()];
        frame[2] = (byte) (text.length() >> 8);
        frame[3] = (byte) text.length();
        for (int i = 0; i < text.length(); i++) {
            frame[4 + i] = (byte) text.charAt(i);
        }
        return frame;
    }
}
