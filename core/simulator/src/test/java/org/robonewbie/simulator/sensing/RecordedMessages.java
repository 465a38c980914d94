package org.robonewbie.simulator.sensing;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.zip.GZIPInputStream;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.perceptor.PerceptorMessage;
import org.robonewbie.protocol.perceptor.PerceptorMessageReader;

/** The messages that a real rcssserver3d sent to an agent. */
final class RecordedMessages {

    private RecordedMessages() {}

    static List<PerceptorMessage> read(String name) throws IOException {
        String resource = "/org/robonewbie/simulator/messages/" + name + ".txt.gz";
        List<PerceptorMessage> messages = new ArrayList<>();
        PerceptorMessageReader reader = new PerceptorMessageReader();
        try (BufferedReader lines = new BufferedReader(new InputStreamReader(
                new GZIPInputStream(Objects.requireNonNull(RecordedMessages.class.getResourceAsStream(resource))),
                StandardCharsets.UTF_8))) {
            for (String line = lines.readLine(); line != null; line = lines.readLine()) {
                if (line.startsWith("(")) {
                    MessageBuffer buffer = new MessageBuffer();
                    buffer.append(line);
                    messages.add(reader.read(buffer));
                }
            }
        }
        return messages;
    }
}
