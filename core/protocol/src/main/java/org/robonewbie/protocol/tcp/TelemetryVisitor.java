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
import org.robonewbie.protocol.telemetry.NumberWish;
import org.robonewbie.protocol.telemetry.TelemetryItem.DeclaredNumber;
import org.robonewbie.protocol.telemetry.TelemetryLine;
import org.robonewbie.protocol.telemetry.TelemetryMessage;
import org.robonewbie.protocol.telemetry.TelemetrySink;

/** A program of another process that tells a {@link TelemetryServer} what its robots think. */
final class TelemetryVisitor implements AutoCloseable {

    private static final int LONGEST_LINE = 200_000;
    private static final int MAX_NUMBERS = 1000;

    private final Socket socket;
    private final TelemetrySink sink;
    private final Set<String> numbers = ConcurrentHashMap.newKeySet();

    TelemetryVisitor(Socket socket, TelemetrySink sink) {
        this.socket = socket;
        this.sink = sink;
    }

    /** Hands on what the robots tell, until they leave. */
    void listen() {
        try (socket;
                Reader reader =
                        new BufferedReader(new InputStreamReader(socket.getInputStream(), StandardCharsets.UTF_8))) {
            StringBuilder line = new StringBuilder();
            for (int sign = reader.read(); sign >= 0 && line.length() < LONGEST_LINE; sign = reader.read()) {
                if (sign == '\n') {
                    TelemetryLine.read(line.toString()).ifPresent(this::hear);
                    line.setLength(0);
                } else {
                    line.append((char) sign);
                }
            }
        } catch (IOException gone) {
            // a robot that leaves in the middle of a line has nothing more to say
        }
    }

    private void hear(TelemetryMessage message) {
        if (message.item() instanceof DeclaredNumber number && numbers.size() < MAX_NUMBERS) {
            numbers.add(key(message.team(), message.number(), number.name()));
        }
        sink.accept(message);
    }

    /**
     * Hands a wish on if it is for a robot of this program. Others, such as programs of older versions that never read, get nothing.
     *
     * @param wish for a number
     * @return whether it was handed on
     */
    boolean take(NumberWish wish) {
        if (!numbers.contains(key(wish.team(), wish.number(), wish.name()))) {
            return false;
        }
        try {
            OutputStream out = socket.getOutputStream();
            out.write((wish.write() + "\n").getBytes(StandardCharsets.UTF_8));
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
        } catch (IOException alreadyGone) {
            // closed is closed
        }
    }

    private static String key(String team, int number, String name) {
        return team + "\t" + number + "\t" + name;
    }
}
