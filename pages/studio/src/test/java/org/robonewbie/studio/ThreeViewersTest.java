package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.WebSocket;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.atomic.AtomicInteger;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Three viewers: one page is frozen, one computer sleeps, and the third must not be affected. */
@Tag("slow")
@Timeout(600)
class ThreeViewersTest {

    private static final int CYCLES = 300;

    @Test
    void neitherTheSimulationNorTheThirdIsDisturbed() throws Exception {
        try (TestSimulator simulation = new TestSimulator().withRobot();
                StudioServer studio = StudioServer.start(simulation.control(), 0, AccessToken.random());
                TestPage frozen = new TestPage(studio.oneTimeAddress());
                TestPage lively = new TestPage(studio.oneTimeAddress());
                ClosedLid closed = new ClosedLid(studio.oneTimeAddress())) {
            frozen.nextFrame();
            simulation.awaitTrue(() -> studio.spectators() == 3);
            long start = TestPage.cycleOf(lively.nextFrame());
            lively.seen();
            List<Long> behind = new ArrayList<>();
            for (long cycle = start; cycle < start + CYCLES; ) {
                cycle = TestPage.cycleOf(lively.nextFrame());
                lively.seen();
                behind.add(simulation.latest().cycle() - cycle);
            }
            behind.sort(Comparator.naturalOrder());

            assertThat(behind.get(behind.size() / 2))
                    .as("cycles by which the lively page was usually behind")
                    .isLessThan(60);
            assertThat(frozen.framesWithin(1))
                    .as("the frozen page got no second frame")
                    .isFalse();
            assertThat(closed.frames.get()).isZero();
            assertThat(studio.spectators()).isEqualTo(3);

            frozen.seen();

            assertThat(TestPage.cycleOf(frozen.nextFrame())).isGreaterThanOrEqualTo(start + CYCLES);
        }
    }

    /** Connects and then never reads again, as a sleeping computer does: data pile up in the network. */
    private static final class ClosedLid implements WebSocket.Listener, AutoCloseable {

        private final AtomicInteger frames = new AtomicInteger();
        private final WebSocket socket;

        ClosedLid(URI studio) {
            socket = HttpClient.newHttpClient()
                    .newWebSocketBuilder()
                    .header("Origin", "http://" + studio.getAuthority())
                    .header("Cookie", StudioCookie.of(studio))
                    .buildAsync(URI.create("ws://" + studio.getAuthority() + "/live"), this)
                    .join();
        }

        @Override
        public void onOpen(WebSocket webSocket) {
            // Requests no data.
        }

        @Override
        public @Nullable CompletionStage<?> onBinary(WebSocket webSocket, ByteBuffer data, boolean last) {
            frames.incrementAndGet();
            return null;
        }

        @Override
        public void close() {
            socket.abort();
        }
    }
}
