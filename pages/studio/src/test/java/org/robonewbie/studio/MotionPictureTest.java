package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Follows {@code docs/first-motion.md} and takes its screenshots.
 */
@Tag("slow")
@Tag("picture")
class MotionPictureTest {

    private static final String STATE = "studio.motion.editor.state";
    private static final String FRAMES = STATE + ".history.present.value.lines.filter(line => line.keyframe)";

    @TempDir
    private Path folder;

    @Test
    void firstMotionIsMadeAsTheGuideSays() throws IOException {
        Tool.BROWSER.orSkip();
        for (String name : List.of("my-kick", "my-dance")) {
            Files.writeString(folder.resolve(name + ".txt"), "// still empty\n");
        }
        try (TestSimulator simulation = new TestSimulator().withRobot();
                WholeStudio studio = new WholeStudio(simulation.control(), folder);
                Chromium browser = Chromium.open(1366, 768)) {
            browser.visit(studio.oneTimeAddress() + "&quality=high&theme=light#motion/wave");
            browser.await("studio.motion && " + STATE + ".name === 'wave' && studio.motion.editor.marks");
            browser.click("#new-motion");
            browser.await(FRAMES + ".length === 1");
            turn(browser, "LEFT_SHOULDER_YAW", 60);
            show(browser, 0);
            Picture.ofDocumentation("docs/images/first-motion-1.png", browser.screenshot());
            for (int angle : List.of(20, 70)) {
                browser.click("#insert");
                turn(browser, "LEFT_SHOULDER_PITCH", 60);
                turn(browser, "LEFT_SHOULDER_YAW", angle);
            }
            browser.await(FRAMES + ".length === 3");
            show(browser, 1);
            Picture.ofDocumentation("docs/images/first-motion-2.png", browser.screenshot());
            browser.click("#trial");
            browser.await(STATE + ".trial && !" + STATE + ".playing");
            browser.evaluate("studio.motion.editor.apply(state => ({...state, time: 1500}))");
            browser.await("!studio.motion.stale && document.querySelector('#toast').hidden");
            Picture.ofDocumentation("docs/images/first-motion-3.png", browser.screenshot());

            assertThat(browser.complaints()).isEmpty();
        }
    }

    private static void turn(Chromium browser, String joint, int degrees) {
        browser.evaluate(
                "(() => { const field = document.querySelector(\"[data-joint='" + joint + "']\"); field.focus();"
                        + " field.value = '" + degrees
                        + "'; field.dispatchEvent(new Event('input')); field.dispatchEvent(new Event('change')); })()");
    }

    private static void show(Chromium browser, int keyframe) {
        browser.evaluate("import('./state/motion/editor-state.js').then(({ selected }) =>"
                + " studio.motion.editor.apply(state => selected(state, " + keyframe + ")))");
        browser.await("!studio.motion.stale && document.querySelector('#toast').hidden");
    }
}
