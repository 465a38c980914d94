package org.robonewbie.protocol.perceptor;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.FieldSource;
import org.robonewbie.protocol.RecordedMessages;
import org.robonewbie.protocol.frame.MessageBuffer;

class RecordedMessagesTest {

    @SuppressWarnings("unused")
    private static final List<String> NAMES = RecordedMessages.NAMES;

    @ParameterizedTest
    @FieldSource("NAMES")
    void messagesOfARealServerAreWrittenAsTheyWereRead(String name) {
        PerceptorMessageReader reader = new PerceptorMessageReader();
        List<String> messages = RecordedMessages.load(name);

        assertThat(messages).hasSizeBetween(100, 120);
        for (String recorded : messages) {
            PerceptorMessage message = reader.read(buffer(recorded));

            assertThat(written(message)).isEqualTo(recorded);
        }
    }

    private static MessageBuffer buffer(String text) {
        MessageBuffer buffer = new MessageBuffer();
        buffer.append(text);
        return buffer;
    }

    private static String written(PerceptorMessage message) {
        MessageBuffer buffer = new MessageBuffer();
        new PerceptorMessageWriter(buffer).write(message);
        return buffer.toString();
    }
}
