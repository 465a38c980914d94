package org.robonewbie.protocol.monitor;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Objects;
import java.util.zip.GZIPInputStream;

/** What a real rcsssmj 0.2.1 sent to monitors. */
final class RecordedRsmpMessages {

    /** One T1 that is beamed, falls while it is not controlled, and is moved by a trainer. */
    static final String T1 = "rsmp_t1.txt.gz";

    /** A T1 and an ant of the left team and a K1 of the right, from the join of the ant on. */
    static final String T1_K1_ANT = "rsmp_t1_k1_ant.txt.gz";

    private RecordedRsmpMessages() {}

    static List<String> load(String resource) {
        try (BufferedReader reader = new BufferedReader(new InputStreamReader(
                new GZIPInputStream(Objects.requireNonNull(RecordedRsmpMessages.class.getResourceAsStream(resource))),
                StandardCharsets.UTF_8))) {
            return reader.lines().toList();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
