package org.robonewbie.agent.running;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.concurrent.CancellationException;
import org.junit.jupiter.api.Test;

class ConnectTimeoutHintTest {

    private final ByteArrayOutputStream said = new ByteArrayOutputStream();
    private final PrintStream err = new PrintStream(said, true, StandardCharsets.UTF_8);

    @Test
    void silentServerIsReportedWithAdvice() {
        ConnectTimeoutHint.after(Duration.ofMillis(1), "localhost:3100", err).await();

        assertThat(said.toString(StandardCharsets.UTF_8))
                .startsWith("No answer from localhost:3100")
                .contains("robonewbie doctor", "--seed 1 starts an embedded simulator");
    }

    @Test
    void serverThatAnswersInTimeIsNotReported() {
        ConnectTimeoutHint notice = ConnectTimeoutHint.after(Duration.ofHours(1), "localhost:3100", err);

        notice.close();

        assertThatThrownBy(notice::await).isInstanceOf(CancellationException.class);
        assertThat(said.size()).isZero();
    }
}
