package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonElement;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.StreamSupport;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Takes a screenshot of each preset in both themes at common screen sizes, written to {@code target/pictures}, and checks that nothing is
 * cut off: each control is inside the window or inside a container that visibly scrolls.
 */
@InBrowser
@Tag("slow")
class PresetPictureTest {

    /** Controls beyond the window that are not inside a scroll container. */
    private static final String CUT_OFF = """
            (() => {
              const scrolls = (each) => each && each !== document.body
                && (['auto', 'scroll'].includes(getComputedStyle(each).overflowY) || scrolls(each.parentElement));
              return [...document.querySelectorAll('button, input, select, summary, a[href]')]
                .filter((each) => each.checkVisibility({visibilityProperty: true}) && !scrolls(each.parentElement))
                .filter((each) => {
                  const {left, top, right, bottom} = each.getBoundingClientRect();
                  return left < 0 || top < 0 || right > innerWidth + 1 || bottom > innerHeight + 1;
                })
                .map((each) => each.id || each.textContent);
            })()""";

    @TempDir
    private Path folder;

    private final Chromium browser;
    private FurnishedStudio studio;

    PresetPictureTest(Chromium browser) {
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

    @ParameterizedTest
    @CsvSource({"1440, 900", "1366, 768", "1024, 768", "820, 1180"})
    void presetsAreSeenInWhole(int width, int height) throws IOException {
        browser.drawSharply();
        browser.resize(width, height);
        for (String theme : List.of("light", "dark")) {
            take("watch", "#field", theme, width, "studio.view.drawCalls > 0");
            take("program", "#program", theme, width, "studio.rooms.program?.files?.file !== undefined");
            take("understand", "#robot", theme, width, "document.querySelectorAll('.joint-row').length === 22");
            take("shape", "#motion/mine", theme, width, "document.querySelector('.keyframe') && !studio.motion.stale");
            take("replay", "#replay/game", theme, width, "studio.replay?.file?.isWhole && !studio.replay.stale");
        }
    }

    private void take(String preset, String room, String theme, int width, String isThere) throws IOException {
        browser.visit("about:blank");
        browser.visit(studio.oneTimeAddress() + "&quality=low&theme=" + theme + room);
        browser.await("studio.state.scene.robots.length === 1 && (" + isThere + ")");
        browser.evaluate("studio.workspace.markMore()");

        Picture.keep(preset + "-" + width + "-" + theme + ".png", browser.screenshot());
        assertThat(cutOff()).as(preset + " at " + width + ", " + theme).isEmpty();
    }

    private List<String> cutOff() {
        return StreamSupport.stream(browser.evaluate(CUT_OFF).getAsJsonArray().spliterator(), false)
                .map(JsonElement::getAsString)
                .toList();
    }
}
