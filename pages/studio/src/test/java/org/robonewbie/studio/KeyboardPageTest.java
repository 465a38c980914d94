package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonElement;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.StreamSupport;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.studio.search.SearchFeed;
import org.robonewbie.studio.search.SearchTask;

/**
 * Keyboard navigation with the Tab key in each room: every control is reachable, shows its focus, and is on the page even on a small
 * projector.
 */
@InBrowser(width = 1024)
@Tag("slow")
class KeyboardPageTest {

    /** Records the controls, which of them have had the focus, and which of those showed no focus ring. */
    private static final String WALK = """
            window.walk = (() => {
              const controls = 'button, a[href], input, select, textarea, summary,'
                + ' [role=button], [role=slider], [role=tab], [tabindex="0"]';
              const isUsable = (each) => !each.disabled && each.checkVisibility({visibilityProperty: true})
                && each.getClientRects().length > 0;
              const groupOf = (each) => each.type === 'radio' ? each.name : each;
              const name = (each) => `${each.tagName} ${each.id} ${each.getAttribute('aria-label') ?? ''}`
                + ` ${each.textContent.trim().slice(0, 30)}`;
              const reached = new Set();
              const plain = new Set();
              document.addEventListener('focusin', ({target}) => {
                const ring = getComputedStyle(target);
                reached.add(groupOf(target));
                if (ring.outlineStyle === 'none' || parseFloat(ring.outlineWidth) < 2) {
                  plain.add(name(target));
                }
              });
              const missed = () => [...document.querySelectorAll(controls)]
                .filter((each) => isUsable(each) && !reached.has(groupOf(each))).map(name);
              const beside = () => [...document.querySelectorAll(controls)].filter(isUsable)
                .filter((each) => each.getBoundingClientRect().right > innerWidth + 1).map(name);
              return {missed, beside, plain: () => [...plain], count: () => document.querySelectorAll(controls).length};
            })()""";

    @TempDir
    private Path folder;

    private final Chromium browser;
    private FurnishedStudio studio;

    KeyboardPageTest(Chromium browser) {
        this.browser = browser;
    }

    @BeforeEach
    void open() throws IOException {
        studio = new FurnishedStudio(folder).paused();
    }

    @AfterEach
    void close() {
        studio.close();
    }

    @Test
    void fieldIsReachable() {
        visit("#field", "studio.view.drawCalls > 0");

        walkThrough();
    }

    @Test
    void exercisesAreReachable() {
        visit("#field/exercises", "document.querySelector('[data-exercise=kick]')");
        browser.click("[data-exercise=kick]");
        browser.await("document.querySelector('#course-program').options.length === 2");

        walkThrough();
    }

    @Test
    void robotIsReachable() {
        visit("#robot", "document.querySelectorAll('.joint-row').length === 22");

        walkThrough();
    }

    @Test
    void motionEditorIsReachable() {
        visit("#motion/mine", "studio.motion?.editor.state.name === 'mine' && !studio.motion.stale");

        walkThrough();
    }

    @Test
    void arrowsOnTheTimelineChooseTheKeyframe() {
        visit("#motion/mine", "studio.motion?.editor.state.name === 'mine' && !studio.motion.stale");
        browser.evaluate("document.querySelector('#motion-timeline').focus()");

        browser.press("ArrowRight");
        browser.await("document.querySelector('.keyframe.chosen')?.dataset.keyframe === '1'");
        browser.press("ArrowLeft");

        browser.await("document.querySelector('.keyframe.chosen')?.dataset.keyframe === '0'");
        browser.await("document.activeElement.id === 'motion-timeline'");
    }

    @Test
    void replayIsReachable() {
        visit("#replay/game", "studio.replay?.file?.isWhole && studio.cursor.recorded && !studio.replay.stale");

        walkThrough();
    }

    @Test
    void listOfKeysOpensWithTheFocusOnItsButton() {
        visit("#field", "studio.view.drawCalls > 0");

        browser.click("#help-button");

        browser.await("document.querySelector('#help').open && document.activeElement.textContent === 'Close'");
    }

    @Test
    void searchIsReachable() throws IOException {
        SearchFeed board = new SearchFeed(new SearchTask("kick", "kick-distance", "m", true, 3, "3 rounds"));
        StudioFolders folders = new StudioFolders(folder, Optional.empty());
        try (StudioServer other = StudioServer.start(
                studio.simulation().control(), 0, AccessToken.random(), folders, Optional.of(board))) {
            browser.visit(board.page(other.oneTimeAddress()).toString());
            browser.await("search.state.task !== undefined");

            walkThrough();
        }
    }

    private void visit(String room, String isThere) {
        browser.visit(studio.oneTimeAddress() + "&quality=lowest&theme=light" + room);
        browser.await("studio.state.scene.robots.length === 1 && studio.state.frame.paused"
                + " && !document.querySelector('#toggle').disabled && document.querySelector('#toast').hidden");
        browser.await(isThere);
    }

    /** Presses Tab until every control has had the focus, at most twice as often as there are controls. */
    private void walkThrough() {
        browser.evaluate(WALK + "; true");
        int most = 30 + 2 * browser.evaluate("walk.count()").getAsInt();
        for (int i = 0; i < most && !texts("walk.missed()").isEmpty(); i++) {
            browser.press("Tab");
        }

        assertThat(texts("walk.missed()"))
                .as("controls that Tab does not reach")
                .isEmpty();
        assertThat(texts("walk.beside()")).as("controls beside the page").isEmpty();
        assertThat(texts("walk.plain()")).as("controls without a ring").isEmpty();
    }

    private List<String> texts(String expression) {
        return StreamSupport.stream(
                        browser.evaluate(expression).getAsJsonArray().spliterator(), false)
                .map(JsonElement::getAsString)
                .toList();
    }
}
