package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Follows {@code docs/first-motion.md} and takes its screenshots: to {@code target/pictures}, or to the folder of {@code
 * -Dstudio.pictures=../../docs/images}.
 */
@Tag("slow")
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
                StudioServer studio = StudioServer.start(
                        simulation.control(), 0, AccessToken.random(), new StudioFolders(folder, Optional.empty()));
                Chromium browser = Chromium.open(1366, 768)) {
            browser.visit(studio.oneTimeAddress() + "&quality=high&theme=light#motion/wave");
            browser.await("studio.motion && " + STATE + ".name === 'wave' && studio.motion.editor.marks");
            show(browser, 2);
            save(browser, "studio-motion.png");
            browser.evaluate("document.querySelector('#theme-button').click()");
            show(browser, 2);
            save(browser, "studio-motion-dark.png");
            browser.evaluate("document.querySelector('#theme-button').click()");

            browser.click("#new-motion");
            browser.await(FRAMES + ".length === 1");
            turn(browser, "LEFT_SHOULDER_YAW", 60);
            show(browser, 0);
            save(browser, "first-motion-1.png");
            for (int angle : List.of(20, 70)) {
                browser.click("#insert");
                turn(browser, "LEFT_SHOULDER_PITCH", 60);
                turn(browser, "LEFT_SHOULDER_YAW", angle);
            }
            browser.await(FRAMES + ".length === 3");
            show(browser, 1);
            save(browser, "first-motion-2.png");
            browser.click("#trial");
            browser.await(STATE + ".trial && !" + STATE + ".playing");
            browser.evaluate("studio.motion.editor.apply(state => ({...state, time: 1500}))");
            browser.await("!studio.motion.stale && document.querySelector('#toast').hidden");
            save(browser, "first-motion-3.png");

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

    private static void save(Chromium browser, String name) throws IOException {
        Path pictures = Path.of(System.getProperty("studio.pictures", "target/pictures"));
        Files.write(Files.createDirectories(pictures).resolve(name), browser.screenshot());
    }
}
