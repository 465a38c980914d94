package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Three real pages, one of which hangs and one of which vanishes with its browser: the third and the simulation are not affected. */
@InBrowser(width = 640, height = 360)
@Timeout(600)
@Tag("slow")
class HangingBrowserTest {

    private static final String SEES = "studio.state.frame && studio.view.drawCalls > 0";

    private final Chromium hanging;

    HangingBrowserTest(Chromium hanging) {
        this.hanging = hanging;
    }

    @Test
    void hangingPageAffectsNoOtherPageAndCatchesUp() throws Exception {
        try (TestSimulator simulation = new TestSimulator().withRobot();
                StudioServer studio = StudioServer.start(simulation.control(), 0, AccessToken.random());
                TestPage third = new TestPage(studio.oneTimeAddress())) {
            hanging.visit(studio.oneTimeAddress() + "&quality=lowest");
            hanging.await(SEES);
            try (Chromium vanishing = Chromium.open(640, 360)) {
                vanishing.visit(studio.oneTimeAddress() + "&quality=lowest");
                vanishing.await(SEES);
                simulation.awaitTrue(() -> studio.spectators() == 3);
            }

            hanging.freeze();
            List<Long> behind = new ArrayList<>();
            long start = TestPage.cycleOf(third.nextFrame());
            long cycle = start;
            while (cycle < start + 100) {
                third.seen();
                cycle = TestPage.cycleOf(third.nextFrame());
                behind.add(simulation.latest().cycle() - cycle);
            }
            hanging.thaw();

            behind.sort(Comparator.naturalOrder());
            assertThat(behind.get(behind.size() / 2))
                    .as("cycles behind, usually")
                    .isLessThan(60);
            hanging.await("studio.state.frame.cycle > " + cycle);
            assertThat(hanging.complaints()).isEmpty();
        }
    }
}
