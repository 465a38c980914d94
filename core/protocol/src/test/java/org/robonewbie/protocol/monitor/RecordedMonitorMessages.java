package org.robonewbie.protocol.monitor;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Objects;
import java.util.zip.GZIPInputStream;
import org.robonewbie.protocol.frame.MessageBuffer;

/** What a real rcssserver3d 0.7.3 sent to a monitor: a full message, 50 changes, and one more full message among them. */
public final class RecordedMonitorMessages {

    private static final String RESOURCE = "g_monitor_first_and_50_updates.txt.gz";

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

    /** A message of this text. */
    public static MessageBuffer message(String text) {
        MessageBuffer message = new MessageBuffer();
        message.append(text);
        return message;
    }
}
