package org.robonewbie.simulator.embedded;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.io.SequenceInputStream;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Collections;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;

class EnterKeyTest {

    private final AtomicInteger number = new AtomicInteger();
    private final ByteArrayOutputStream terminal = new ByteArrayOutputStream();
    private final SharedInput program = new SharedInput();

    @Test
    void eachEnterPrintsAnotherAddress() {
        listen("\n", "anything\n");

        assertThat(terminal.toString(StandardCharsets.UTF_8))
                .isEqualToNormalizingNewlines("Studio: http://127.0.0.1/?code=1\nStudio: http://127.0.0.1/?code=2\n");
    }

    @Test
    void programThatReadsReceivesTheLines() throws IOException {
        assertThat(program.offer(new byte[1])).isFalse();
        assertThat(program.read(new byte[0])).isZero(); // a program begins to read

        listen("Ada\n", "x\n");

        assertThat(program.readAllBytes()).asString(StandardCharsets.UTF_8).isEqualTo("Ada\nx\n");
        assertThat(terminal.size()).isZero();
    }

    @Test
    void programThatReadsAfterTheEndIsNotBlocked() throws IOException {
        listen("\n");

        assertThat(program.read()).isEqualTo(-1);
    }

    private void listen(String... lines) {
        SequenceInputStream keyboard = new SequenceInputStream(Collections.enumeration(Arrays.stream(lines)
                .map(line -> new ByteArrayInputStream(line.getBytes(StandardCharsets.UTF_8)))
                .toList()));
        EnterKey.listen(
                keyboard,
                program,
                () -> URI.create("http://127.0.0.1/?code=" + number.incrementAndGet()),
                new PrintStream(terminal, true, StandardCharsets.UTF_8));
    }
}
