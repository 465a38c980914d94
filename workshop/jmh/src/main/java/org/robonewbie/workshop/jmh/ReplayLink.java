package org.robonewbie.workshop.jmh;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Objects;
import java.util.zip.GZIPInputStream;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.frame.MessageBuffer;

/** Connection without a server: repeats the messages of a recording and discards the replies. */
final class ReplayLink implements AgentLink {

    private static final String RECORDING =
            "/org/robonewbie/protocol/recorded/a_agent_two_teams_hear_playon_noise.txt.gz";
    private static final List<byte[]> MESSAGES = load();

    /**
     * First message, with the uniform number and the side: a server sends these only once, and a robot needs them
     * before it plays.
     */
    private static final byte[] WELCOME =
            "(time (now 0.02))(GS (unum 1) (team left) (t 0.00) (pm PlayOn))".getBytes(StandardCharsets.US_ASCII);

    private static final int WELCOMES = 3;

    private int next = -WELCOMES;

    /** Copies one message without allocation. */
    @Override
    public boolean receive(MessageBuffer buffer) {
        byte[] message = next < 0 ? WELCOME : MESSAGES.get(next);
        next = (next + 1) % MESSAGES.size();
        buffer.clear();
        for (byte sign : message) {
            buffer.append(sign);
        }
        return true;
    }

    @Override
    public void send(MessageBuffer message) {}

    @Override
    public boolean isMessageWaiting() {
        return false;
    }

    @Override
    public void close() {}

    private static List<byte[]> load() {
        try (BufferedReader reader = new BufferedReader(new InputStreamReader(
                new GZIPInputStream(Objects.requireNonNull(ReplayLink.class.getResourceAsStream(RECORDING))),
                StandardCharsets.US_ASCII))) {
            return reader.lines()
                    .filter(line -> line.startsWith("("))
                    .map(line -> line.getBytes(StandardCharsets.US_ASCII))
                    .toList();
        } catch (IOException broken) {
            throw new UncheckedIOException(broken);
        }
    }
}
