package org.robonewbie.protocol;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Objects;
import java.util.zip.GZIPInputStream;

/** Messages that a real rcssserver3d 0.7.3, or RCSSServerMJ 0.2.1, sent to an agent. */
public final class RecordedMessages {

    /** 300 messages of RCSSServerMJ to a T1 that is beamed and stands. */
    public static final String LEAGUE_T1 = "league_t1";

    /** 20 messages of RCSSServerMJ to a K1. */
    public static final String LEAGUE_K1 = "league_k1";

    /** The recordings of rcssserver3d, each of 100 or 120 messages. */
    public static final List<String> NAMES = List.of(
            "a_agent_100msgs_default_realtime_noise",
            "a_agent_100msgs_sync_fast_noise",
            "a_agent_100msgs_sync_fast_nonoise",
            "a_agent_two_teams_hear_playon_noise",
            "a_agent_two_teams_hear_playon_nonoise");

    private RecordedMessages() {}

    /**
     * Loads a recording.
     *
     * @param name one of {@link #NAMES}, {@link #LEAGUE_T1} or {@link #LEAGUE_K1}
     * @return its messages
     */
    public static List<String> load(String name) {
        String resource = "recorded/" + name + ".txt.gz";
        try (BufferedReader reader = new BufferedReader(new InputStreamReader(
                new GZIPInputStream(Objects.requireNonNull(RecordedMessages.class.getResourceAsStream(resource))),
                StandardCharsets.US_ASCII))) {
            return reader.lines().filter(line -> line.startsWith("(")).toList();
        } catch (IOException broken) {
            throw new UncheckedIOException(broken);
        }
    }

    /**
     * Loads all recordings.
     *
     * @return all messages
     */
    public static List<String> loadAll() {
        return NAMES.stream().flatMap(name -> load(name).stream()).toList();
    }
}
