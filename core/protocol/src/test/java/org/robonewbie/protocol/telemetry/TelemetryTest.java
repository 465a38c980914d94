package org.robonewbie.protocol.telemetry;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.protocol.tcp.TelemetryClient;
import org.robonewbie.protocol.tcp.TelemetryServer;

class TelemetryTest {

    private static final List<TelemetryItem> ITEMS = List.of(
            new TelemetryItem.LogEntry("INFO", "a tab \t, a line\r\nbreak and a \\t backslash"),
            new TelemetryItem.MotionProgress("walk-forward", 4),
            new TelemetryItem.MotionProgress("", 0),
            new TelemetryItem.Belief(List.of(), Optional.empty()),
            new TelemetryItem.Belief(
                    List.of(
                            new BelievedThing("ball", new Vector3(1.2, -0.1, -0.45), 0.02, true),
                            new BelievedThing("Blue 3", new Vector3(3, 0, 0), 7.5, false)),
                    Optional.of(new Pose2d(-0.5, 0.4, -40))),
            new TelemetryItem.Picture(List.of(
                    new Drawing.Point(new Vector3(1, 2, 3), "red"),
                    new Drawing.Line(Vector3.ZERO, new Vector3(1, 0, 0), "#ff8800"),
                    new Drawing.Circle(new Vector3(0, 1, 0), 0.25, "blue"),
                    new Drawing.Text(Vector3.ZERO, "go\tthere", "white"))),
            new TelemetryItem.PlotValue("ball distance", 1.25),
            new TelemetryItem.DeclaredNumber("a\tgain", 0.00001, 0, 1, 0.75));
    private static final TelemetryMessage HELLO =
            new TelemetryMessage("Blue", 3, 0, new TelemetryItem.LogEntry("INFO", "hello"));

    @Test
    void eachKindOfMessageIsReadAsItWasWritten() {
        for (TelemetryItem item : ITEMS) {
            TelemetryMessage message = new TelemetryMessage("Blue", 3, 12.34, item);

            assertThat(TelemetryLine.read(TelemetryLine.write(message))).contains(message);
        }
    }

    @Test
    void aMessageIsOneLineOfReadableFields() {
        TelemetryItem entry = new TelemetryItem.LogEntry("WARNING", "two\nlines");

        String line = TelemetryLine.write(new TelemetryMessage("Blue", 3, 12.34, entry));

        assertThat(line).isEqualTo("log\t12.34\tBlue\t3\tWARNING\ttwo\\nlines");
    }

    @Test
    void whatIsNoTelemetryIsNotRead() {
        for (String line : List.of("", "log", "log\t1\tBlue", "log\tx\tBlue\t3\tINFO\ttext", "dance\t1\tBlue\t3\tx")) {
            assertThat(TelemetryLine.read(line)).as(line).isEmpty();
        }
        assertThat(TelemetryLine.read("draw\t1\tBlue\t3\tstar\tred\t0\t0\t0")).isEmpty();
        assertThat(TelemetryLine.read("belief\t1\tBlue\t3\t-\tball\t1\t2")).isEmpty();
    }

    @Test
    void robotsOfOtherProcessesReachTheListener() throws Exception {
        BlockingQueue<TelemetryMessage> heard = new LinkedBlockingQueue<>();
        try (TelemetryServer server = TelemetryServer.open(0, heard::add);
                TelemetryClient client = TelemetryClient.open(server.port())) {
            tellUntilHeard(client, heard);

            for (TelemetryItem item : ITEMS) {
                client.accept(new TelemetryMessage("Blue", 3, 12.34, item));
            }

            for (TelemetryItem item : ITEMS) {
                assertThat(next(heard)).isEqualTo(new TelemetryMessage("Blue", 3, 12.34, item));
            }
        }
    }

    @Test
    void wishForANumberReachesTheProgramThatHasIt() throws Exception {
        BlockingQueue<TelemetryMessage> heard = new LinkedBlockingQueue<>();
        TuningRequests wishes = new TuningRequests();
        try (TelemetryServer server = TelemetryServer.open(0, new Listener(heard, wishes));
                TelemetryClient stranger = TelemetryClient.open(server.port());
                TelemetryClient client = TelemetryClient.open(server.port())) {
            tellUntilHeard(stranger, heard);
            tellUntilHeard(client, heard);
            client.accept(
                    new TelemetryMessage("Blue", 3, 0, new TelemetryItem.DeclaredNumber("my\tgain", 0.5, 0, 1, 0.5)));
            assertThat(next(heard).item()).isInstanceOf(TelemetryItem.DeclaredNumber.class);
            BlockingQueue<TuningRequest> arrived = new LinkedBlockingQueue<>();
            client.tuningRequests().orElseThrow().addForwarder(arrived::add);
            stranger.tuningRequests().orElseThrow().addForwarder(arrived::add);

            TuningRequest wish = new TuningRequest("Blue", 3, "my\tgain", 0.1 + 0.2);
            wishes.put(wish);

            assertThat(arrived.poll(120, TimeUnit.SECONDS)).isEqualTo(wish);
            assertThat(arrived).isEmpty();
            assertThat(wishes.take("Blue", 3, "my\tgain")).isEmpty();
        }
    }

    @Test
    void wishWaitsForARobotOfThisProgramAndIsTakenOnce() {
        TuningRequests wishes = new TuningRequests();

        wishes.put(new TuningRequest("Blue", 3, "gain", 0.2));
        wishes.put(new TuningRequest("Blue", 3, "gain", 0.7));

        assertThat(wishes.take("Blue", 4, "gain")).isEmpty();
        assertThat(wishes.take("Blue", 3, "gain")).hasValue(0.7);
        assertThat(wishes.take("Blue", 3, "gain")).isEmpty();
    }

    @Test
    void whatIsNoWishIsNotRead() {
        for (String line :
                List.of("", "tune", "tune\tBlue\t3\tgain", "tune\tBlue\tx\tgain\t1", "plot\tBlue\t3\tgain\t1")) {
            assertThat(TuningRequest.read(line)).as(line).isEmpty();
        }
    }

    @Test
    void whatWasToldBeforeTheEndArrives() throws Exception {
        BlockingQueue<TelemetryMessage> heard = new LinkedBlockingQueue<>();
        try (TelemetryServer server = TelemetryServer.open(0, heard::add)) {
            TelemetryClient client = TelemetryClient.open(server.port());
            tellUntilHeard(client, heard);

            for (int i = 0; i < 1000; i++) {
                client.accept(new TelemetryMessage("Blue", i, 0, ITEMS.get(0)));
            }
            client.close();

            for (int i = 0; i < 1000; i++) {
                assertThat(next(heard).number()).isEqualTo(i);
            }
            assertThat(client.isWanted()).isFalse();
        }
    }

    @Test
    void nothingIsWantedWhileNobodyListens() throws Exception {
        int free;
        try (TelemetryServer server = TelemetryServer.open(0, message -> {})) {
            free = server.port();
        }
        try (TelemetryClient client = TelemetryClient.open(free)) {
            client.accept(new TelemetryMessage("Blue", 3, 0, ITEMS.get(0)));

            assertThat(client.isWanted()).isFalse();
            assertThat(TelemetrySink.NONE.isWanted()).isFalse();
        }
    }

    @Test
    void rubbishDoesNotDisturbTheServer() throws Exception {
        BlockingQueue<TelemetryMessage> heard = new LinkedBlockingQueue<>();
        try (TelemetryServer server = TelemetryServer.open(0, heard::add)) {
            send(server.port(), "\0\1\2 rubbish\n\n" + "x".repeat(300_000));
            send(server.port(), "rubbish\nplot\t1.0\tBlue\t3\tspeed\t2.0\n");

            assertThat(heard.poll(120, TimeUnit.SECONDS))
                    .isEqualTo(new TelemetryMessage("Blue", 3, 1, new TelemetryItem.PlotValue("speed", 2)));
        }
    }

    @Test
    void telemetryPortIs200AboveTheAgentPort() {
        assertThat(TelemetryServer.portFor(3100)).isEqualTo(3300);
        assertThat(TelemetryServer.portFor(65_400)).isEqualTo(65_200);
    }

    private record Listener(BlockingQueue<TelemetryMessage> heard, TuningRequests numbers) implements TelemetrySink {

        @Override
        public void accept(TelemetryMessage message) {
            heard.add(message);
        }

        @Override
        public Optional<TuningRequests> tuningRequests() {
            return Optional.of(numbers);
        }
    }

    /** What is told before there is a listener is lost, so it is told again until it is heard. */
    private static void tellUntilHeard(TelemetrySink sink, BlockingQueue<TelemetryMessage> heard)
            throws InterruptedException {
        do {
            sink.accept(HELLO);
        } while (heard.poll(20, TimeUnit.MILLISECONDS) == null);
        assertThat(sink.isWanted()).isTrue();
    }

    private static TelemetryMessage next(BlockingQueue<TelemetryMessage> heard) throws InterruptedException {
        TelemetryMessage message = heard.poll(120, TimeUnit.SECONDS);
        while (HELLO.equals(message)) {
            message = heard.poll(120, TimeUnit.SECONDS);
        }
        return Objects.requireNonNull(message, "nothing was heard for two minutes");
    }

    private static void send(int port, String text) throws IOException {
        try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), port)) {
            socket.getOutputStream().write(text.getBytes(StandardCharsets.UTF_8));
        } catch (IOException closedByServer) {
            // a server may hang up on rubbish
        }
    }
}
