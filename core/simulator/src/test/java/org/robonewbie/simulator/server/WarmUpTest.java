package org.robonewbie.simulator.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
class WarmUpTest {

    @Test
    void endsAsSoonAsItIsNoLongerWanted() throws IOException {
        AtomicInteger questions = new AtomicInteger();

        WarmUp.run(() -> questions.incrementAndGet() < 3);

        assertThat(questions.get()).isBetween(3, 5);
    }

    @Tag("slow")
    @Test
    void endsByItself() throws IOException {
        AtomicInteger questions = new AtomicInteger();

        WarmUp.run(() -> questions.incrementAndGet() > 0);

        assertThat(questions.get()).isGreaterThan(3);
    }
}
