package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.net.Socket;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import java.util.zip.GZIPInputStream;
import java.util.zip.GZIPOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.nao.Joint;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.cycle.WorldSettings;
import org.robonewbie.simulator.server.Simulator;
import org.robonewbie.simulator.server.SimulatorSettings;

/**
 * Measures the bytes per second on the wire to one page of the studio while 22 robots move all their joints in real time, for
 * {@code docs/performance.md}: with and without the messages of one robot, compressed and not; and the sizes of the recording and of the
 * text in an exported page. Not part of the usual tests, since it takes a minute: {@code -Dtest=StreamMeasurement}.
 */
class StreamMeasurement {

    private static final int SECONDS = 10;
    private static final int COMMANDS = 4;
    private static final int HEAD_BYTES = 22;
    private static final String PACKED = "Sec-WebSocket-Extensions: permessage-deflate\r\n";

    @TempDir
    private Path folder;

    @Test
    void bytesForOnePage() throws IOException {
        Path recording = folder.resolve("run.rec");
        SimulatorSettings settings = SimulatorSettings.of(WorldSettings.beginner())
                .withAgentPort(0)
                .withAwaitedAgents(22)
                .withOutput(Optional.of(recording), Optional.empty());
        long cycles;
        try (Simulator simulator = Simulator.start(settings, Console.silent());
                StudioServer studio = StudioServer.start(simulator.control(), 0, AccessToken.random())) {
            for (int number = 0; number < 22; number++) {
                new Thread(player(simulator, number), "player-" + number).start();
            }
            for (String extension : new String[] {PACKED, ""}) {
                double frames = measure(studio.oneTimeAddress(), extension, "");
                double withMessages = measure(
                        studio.oneTimeAddress(), extension, "{\"do\":\"watch\",\"team\":\"Left\",\"number\":1}");
                System.out.printf(
                        Locale.ROOT,
                        "%s: %.1f KiB/s, with the messages of one robot %.1f KiB/s%n",
                        extension.isEmpty() ? "plain" : "packed",
                        frames,
                        withMessages);
                assertThat(frames).isBetween(1.0, 60.0);
                assertThat(withMessages).isGreaterThan(frames);
            }
            cycles = studio.feed().now().cycle();
        }
        double minutes = cycles / 3000.0;
        double perMinute = Files.size(recording) / 1e6 / minutes;
        System.out.printf(
                Locale.ROOT,
                "recording: %.2f MB per minute, as text in an HTML file %.2f MB per minute%n",
                perMinute,
                packedWithoutCommands(recording) / 1e6 * 4 / 3 / minutes);
        assertThat(perMinute).isPositive();
    }

    /** Size of the recording's data in an exported page. */
    private static int packedWithoutCommands(Path recording) throws IOException {
        ByteArrayOutputStream packed = new ByteArrayOutputStream();
        try (DataInputStream in = new DataInputStream(
                        new GZIPInputStream(new BufferedInputStream(Files.newInputStream(recording))));
                OutputStream out = new GZIPOutputStream(packed)) {
            out.write(in.readNBytes(HEAD_BYTES));
            for (int kind = in.read(); kind >= 0; kind = in.read()) {
                byte[] content = in.readNBytes(unsigned(in));
                if (kind != COMMANDS) {
                    out.write(new byte[] {(byte) kind, (byte) content.length, (byte) (content.length >> 7)});
                    out.write(content);
                }
            }
        }
        return packed.size();
    }

    private static int unsigned(DataInputStream in) throws IOException {
        int value = 0;
        for (int shift = 0; ; shift += 7) {
            int next = in.readUnsignedByte();
            value |= (next & 127) << shift;
            if (next < 128) {
                return value;
            }
        }
    }

    private static double measure(URI studio, String extension, String command) throws IOException {
        try (Socket socket = new Socket(studio.getHost(), studio.getPort())) {
            String address = "127.0.0.1:" + studio.getPort();
            String cookie = StudioCookie.of(studio);
            write(
                    socket,
                    ("GET /live HTTP/1.1\r\nHost: " + address + "\r\nOrigin: http://" + address + "\r\nCookie: "
                                    + cookie
                                    + "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
                                    + extension + "Sec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\n\r\n")
                            .getBytes(StandardCharsets.US_ASCII));
            DataInputStream in = new DataInputStream(socket.getInputStream());
            skipHead(in);
            if (!command.isEmpty()) {
                say(socket, command);
            }
            read(socket, in, 3);
            return read(socket, in, SECONDS) / 1024.0 / SECONDS;
        }
    }

    private static void skipHead(DataInputStream in) throws IOException {
        for (int last = 0; last != 0x0d0a0d0a; ) {
            last = (last << 8) | in.readUnsignedByte();
        }
    }

    /** Reads frames for some seconds and acknowledges each one. */
    private static long read(Socket socket, DataInputStream in, int seconds) throws IOException {
        long bytes = 0;
        for (long end = System.nanoTime() + seconds * 1_000_000_000L; System.nanoTime() < end; ) {
            int kind = in.readUnsignedByte() & 15;
            int size = in.readUnsignedByte();
            int head = size == 126 ? 4 : size == 127 ? 10 : 2;
            long length = size == 126 ? in.readUnsignedShort() : size == 127 ? in.readLong() : size;
            in.skipNBytes(length);
            bytes += head + length;
            if (kind == 2) {
                say(socket, "{\"do\":\"seen\"}");
            }
        }
        return bytes;
    }

    /** Sends a short text with a mask of zeros. */
    private static void say(Socket socket, String text) throws IOException {
        byte[] content = text.getBytes(StandardCharsets.US_ASCII);
        byte[] frame = Arrays.copyOf(new byte[] {(byte) 0x81, (byte) (0x80 | content.length)}, 6 + content.length);
        System.arraycopy(content, 0, frame, 6, content.length);
        write(socket, frame);
    }

    private static void write(Socket socket, byte[] bytes) throws IOException {
        socket.getOutputStream().write(bytes);
        socket.getOutputStream().flush();
    }

    private static Runnable player(Simulator simulator, int index) {
        AgentLink link = simulator.connect();
        return () -> {
            try (link) {
                send(link, "(scene rsg/agent/nao/nao.rsg)");
                MessageBuffer percepts = new MessageBuffer();
                for (int cycle = 0; link.receive(percepts); cycle++) {
                    send(
                            link,
                            cycle == 0
                                    ? "(init (unum " + (index % 11 + 1) + ")(teamname " + team(index) + "))"
                                    : act(index, cycle));
                }
            } catch (IOException matchIsOver) {
                // The simulator has ended.
            }
        };
    }

    private static String team(int index) {
        return index < 11 ? "Left" : "Right";
    }

    private static String act(int index, int cycle) {
        if (cycle == 3) {
            return String.format(
                    Locale.ROOT, "(beam %.1f %.1f 0)", -1.0 - Math.floorDiv(index % 11, 3), 1.5 * (index % 3 - 1));
        }
        StringBuilder all = new StringBuilder();
        for (Joint joint : Joint.values()) {
            double speed = 0.7 * Math.sin(0.3 * cycle + index + joint.ordinal());
            all.append(String.format(Locale.ROOT, "(%s %.4f)", joint.effectorName(), speed));
        }
        return all.toString();
    }

    private static void send(AgentLink link, String text) throws IOException {
        MessageBuffer message = new MessageBuffer();
        message.append(text + "(syn)");
        link.send(message);
    }
}
