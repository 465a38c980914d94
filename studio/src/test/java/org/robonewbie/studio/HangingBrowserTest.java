package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Three real pages, of which one hangs and one vanishes with its browser: the third and the simulation go on. */
@InBrowser(width = 640, height = 360)
@Timeout(240)
class HangingBrowserTest {

    private static final String SEES = "studio.state.frame && studio.view.drawCalls > 0";
    private static final String HANG =
            "(() => { for (const end = performance.now() + 6000; performance.now() < end; ); })()";

    private final Chromium hanging;

    HangingBrowserTest(Chromium hanging) {
        this.hanging = hanging;
    }

    @Test
    void othersDoNotNoticeAndItCatchesUp() throws Exception {
        try (SmallSimulation simulation = new SmallSimulation().withRobot().start();
                StudioServer studio = StudioServer.start(simulation, 0, AccessToken.random());
                TestPage third = new TestPage(studio.address())) {
            String address = studio.address() + "&quality=lowest";
            hanging.visit(address);
            hanging.await(SEES);
            try (Chromium vanishing = Chromium.open(640, 360)) {
                vanishing.visit(address);
                vanishing.await(SEES);
                assertThat(studio.spectators()).isEqualTo(3);
            }

            CompletableFuture<Void> hang = CompletableFuture.runAsync(() -> hanging.evaluate(HANG));
            long start = TestPage.cycleOf(third.nextFrame());
            long cycle = start;
            while (cycle < start + 100) {
                third.seen();
                cycle = TestPage.cycleOf(third.nextFrame());
            }

            assertThat(hang).as("still hanging").isNotDone();
            assertThat(simulation.latest().cycle() - cycle).as("cycles behind").isLessThan(60);
            hang.join();
            hanging.await("studio.state.frame.cycle > " + cycle);
            assertThat(hanging.complaints()).isEmpty();
        }
    }
}
