package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Messages of the motion editor about names, unreadable files, and motions made for RoboNewbie 1.1. */
@Tag("slow")
@InBrowser
class MotionImportPageTest {

    private static final String STATE = "studio.motion.editor.state";
    private static final String LINES = STATE + ".history.present.value.lines";
    private static final String SKIPPED =
            "400" + " 0".repeat(22) + "\r\n20" + " 1".repeat(22) + "\r\n400" + " 2".repeat(22) + "\r\n";

    @TempDir
    private Path folder;

    private final Chromium browser;
    private FurnishedStudio studio;

    MotionImportPageTest(Chromium browser) {
        this.browser = browser;
    }

    @BeforeEach
    void open() throws IOException {
        studio = new FurnishedStudio(folder);
    }

    @AfterEach
    void close() {
        studio.close();
    }

    private void visit(String motion) {
        browser.visit(studio.oneTimeAddress() + "&quality=lowest&theme=light#motion/" + motion);
        browser.await("studio.motion && " + LINES + ".length > 0 && !studio.motion.stale");
    }

    private void importFile(String name, String text) {
        browser.evaluate("HTMLInputElement.prototype.click = function () { const choice = new DataTransfer();"
                + " choice.items.add(new File([" + Chromium.quoted(text) + "], " + Chromium.quoted(name) + "));"
                + " this.files = choice.files; this.dispatchEvent(new Event('change')); }");
        browser.click("#import");
    }

    private void awaitText(String text) {
        browser.await("document.body.innerText.includes(" + Chromium.quoted(text) + ")");
    }

    @Test
    void nameMayHaveLettersOfAnyLanguageAndAnInvalidOneIsReported() throws IOException {
        visit("mine");
        browser.click("#new-motion");
        browser.await(STATE + ".name === ''");
        browser.click("#save");
        browser.await("document.querySelector('#answer')");

        browser.fill("#answer", "left/right");
        awaitText("The name contains \"/\".");
        assertThat(browser.evaluate("document.querySelector('#accept').disabled")
                        .getAsBoolean())
                .isTrue();
        browser.fill("#answer", "gru\u0308ßen 手を振る");
        browser.click("#accept");

        browser.await(STATE + ".name === 'grüßen 手を振る'");
        assertThat(folder.resolve("grüßen 手を振る.txt")).isRegularFile();
        assertThat(browser.complaints()).isEmpty();
    }

    @Test
    void unplayableFileIsListedWithTheReason() throws IOException {
        Files.writeString(folder.resolve("what?.txt"), SKIPPED);

        visit("mine");

        awaitText("The name of the file what?.txt contains \"?\". Rename it.");
    }

    @Test
    void bytesThatAreNoTextAreRefusedAndStay() throws IOException {
        byte[] bytes = (SKIPPED + "// \u0081").getBytes(StandardCharsets.ISO_8859_1);
        Path file = Files.write(folder.resolve("odd.txt"), bytes);

        visit("odd");
        awaitText("odd.txt cannot be opened: line 4 is neither UTF-8 nor Windows-1252 (byte 0x81).");

        browser.await(STATE + ".name === 'wave'");
        assertThat(file).hasBinaryContent(bytes);
    }

    @Test
    void motionOfTheOldFrameworkIsProposedToBePlayedByItsRule() throws IOException {
        visit("mine");
        importFile("old walk.txt", SKIPPED);

        browser.await("!document.querySelector('#original-rule').hidden");
        browser.click("#play-original");
        browser.await(LINES + "[0].text === '// play: 1.1' && document.querySelector('#original-rule').hidden");
        browser.click("#save");
        browser.await("document.querySelector('#answer')");
        browser.fill("#answer", "old walk");
        browser.click("#accept");
        browser.await(STATE + ".name === 'old walk'");

        assertThat(Files.readString(folder.resolve("old walk.txt"))).isEqualTo("// play: 1.1\r\n" + SKIPPED);
        visit("old%20walk");
        assertThat(browser.evaluate("document.querySelector('#original-rule').hidden")
                        .getAsBoolean())
                .isTrue();
    }

    @Test
    void openedMotionOfTheOldFrameworkMayBeLeftAsItIs() throws IOException {
        Path file = Files.writeString(folder.resolve("old.txt"), SKIPPED);

        visit("old");
        browser.await("!document.querySelector('#original-rule').hidden");
        browser.click("#play-usual");
        browser.await("document.querySelector('#original-rule').hidden");

        assertThat(file).hasContent(SKIPPED);
    }

    @Test
    void importWithoutEffectIsRefused() {
        visit("mine");
        importFile("theirs.motion", "#WEBOTS_MOTION,V1.0,l_knee\n00:01:000,Pose1,1.2\n");

        awaitText("theirs.motion was not imported: line 1 names no joint of this robot: found “l_knee”.");
        assertThat(browser.evaluate(STATE + ".name").getAsString()).isEqualTo("mine");
    }
}
