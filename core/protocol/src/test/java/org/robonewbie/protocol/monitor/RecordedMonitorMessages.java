package org.robonewbie.protocol.monitor;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Objects;
import java.util.Random;
import java.util.zip.GZIPInputStream;
import org.robonewbie.protocol.frame.MessageBuffer;

/** What real servers sent to a monitor. */
public final class RecordedMonitorMessages {

    /** Of rcssserver3d 0.7.3: a full message, 50 changes, and one more full message among them. */
    static final String SIMSPARK = "g_monitor_first_and_50_updates.txt.gz";

    /** Of rcsssmj 0.2.1: one T1 that is beamed, falls while it is not controlled, and is moved by a trainer. */
    static final String T1 = "rsmp_t1.txt.gz";

    /** Of rcsssmj 0.2.1: a T1 and an ant of the left team and a K1 of the right, from the join of the ant on. */
    static final String T1_K1_ANT = "rsmp_t1_k1_ant.txt.gz";

    private RecordedMonitorMessages() {}

    static List<String> load(String resource) {
        try (BufferedReader reader = new BufferedReader(new InputStreamReader(
                new GZIPInputStream(
                        Objects.requireNonNull(RecordedMonitorMessages.class.getResourceAsStream(resource))),
                StandardCharsets.UTF_8))) {
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

    /** A message of this text in which some characters are replaced, and which may end early. */
    static MessageBuffer damaged(String text, Random random) {
        MessageBuffer message = message(text);
        String replacements = "() 0-9ne;Tx\n\"";
        for (int k = random.nextInt(4); k >= 0; k--) {
            message.bytes()[random.nextInt(message.length())] =
                    (byte) replacements.charAt(random.nextInt(replacements.length()));
        }
        message.resize(random.nextBoolean() ? message.length() : random.nextInt(message.length()));
        return message;
    }
}
