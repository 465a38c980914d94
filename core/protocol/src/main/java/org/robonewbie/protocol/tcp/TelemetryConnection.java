package org.robonewbie.protocol.tcp;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.io.Reader;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.robonewbie.protocol.telemetry.TelemetryItem.DeclaredNumber;
import org.robonewbie.protocol.telemetry.TelemetryLine;
import org.robonewbie.protocol.telemetry.TelemetryMessage;
import org.robonewbie.protocol.telemetry.TelemetrySink;
import org.robonewbie.protocol.telemetry.TuningRequest;

/** Server side of the connection to a program that sends the telemetry of its robots to a {@link TelemetryServer}. */
final class TelemetryConnection implements AutoCloseable {

    private static final int MAX_LINE_LENGTH = 200_000;
    private static final int MAX_NUMBERS = 1000;

    private final Socket socket;
    private final TelemetrySink sink;
    private final Set<String> numbers = ConcurrentHashMap.newKeySet();

    TelemetryConnection(Socket socket, TelemetrySink sink) {
        this.socket = socket;
        this.sink = sink;
    }

    /** Receives telemetry until the connection is closed. */
    void receive() {
        try (socket;
                Reader reader =
                        new BufferedReader(new InputStreamReader(socket.getInputStream(), StandardCharsets.UTF_8))) {
            StringBuilder line = new StringBuilder();
            for (int next = reader.read(); next >= 0 && line.length() < MAX_LINE_LENGTH; next = reader.read()) {
                if (next == '\n') {
                    TelemetryLine.read(line.toString()).ifPresent(this::accept);
                    line.setLength(0);
                } else {
                    line.append((char) next);
                }
            }
        } catch (IOException gone) {
            // an incomplete last line is dropped
        }
    }

    private void accept(TelemetryMessage message) {
        if (message.item() instanceof DeclaredNumber number && numbers.size() < MAX_NUMBERS) {
            numbers.add(key(message.team(), message.number(), number.name()));
        }
        sink.accept(message);
    }

    /** Sends a tuning request if a robot of this program has declared the parameter, and returns whether it was sent. */
    boolean forward(TuningRequest request) {
        if (!numbers.contains(key(request.team(), request.number(), request.name()))) {
            return false;
        }
        try {
            OutputStream out = socket.getOutputStream();
            out.write((request.write() + "\n").getBytes(StandardCharsets.UTF_8));
            out.flush();
            return true;
        } catch (IOException gone) {
            return false;
        }
    }

    @Override
    public void close() {
        try {
            socket.close();
        } catch (IOException ignored) {
            // the socket counts as closed anyway
        }
    }

    private static String key(String team, int number, String name) {
        return team + "\t" + number + "\t" + name;
    }
}
