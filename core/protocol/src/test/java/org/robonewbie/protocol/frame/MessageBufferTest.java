package org.robonewbie.protocol.frame;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class MessageBufferTest {

    @ParameterizedTest
    @ValueSource(strings = {"", "(See )", "Größe", "\u0128\u0129", "kick \u2603 \uD83E\uDD16"})
    void textComesOutAsItWentIn(String text) {
        MessageBuffer message = new MessageBuffer(1);
        message.append("<");

        message.append(text);

        assertThat(message).hasToString("<" + text);
    }

    @Test
    void foreignLetterIsNoParenthesis() {
        MessageBuffer message = new MessageBuffer();

        message.append("\u0128 \u0129");

        byte[] written = Arrays.copyOf(message.bytes(), message.length());
        assertThat(new String(written, StandardCharsets.ISO_8859_1)).doesNotContain("(", ")");
    }
}
