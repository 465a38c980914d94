package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** Saved versions of a program are listed, compared and restored, and their files never prevent a save. */
@InBrowser
@Timeout(120)
class ProgramHistoryPageTest {

    private static final int CONTROL = 2;

    @TempDir
    private Path folder;

    private final Chromium browser;
    private FurnishedStudio studio;

    ProgramHistoryPageTest(Chromium browser) {
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

    private Path visit(String text) throws IOException {
        Path file = Files.writeString(folder.resolve("Kick.java"), text);
        browser.visit(studio.oneTimeAddress() + "&theme=light&quality=lowest#program/Kick.java");
        browser.await("studio.rooms.program?.files?.file?.path === 'Kick.java'");
        return file;
    }

    private void write(String text) {
        browser.evaluate("studio.rooms.program.editor.replace(" + Chromium.quoted(text) + ")");
    }

    private void save(String text) {
        write(text);
        browser.click("#program-save");
        awaitSaved(text);
    }

    private void awaitSaved(String text) {
        browser.await("studio.rooms.program.files.file.saved === " + Chromium.quoted(text));
    }

    private void openHistory() {
        browser.click("#program-history");
        browser.await("document.querySelector('#versions')");
    }

    private String shown(String selector) {
        return browser.evaluate("document.querySelector('" + selector + "').innerText")
                .getAsString();
    }

    @Test
    void versionIsComparedAndRestoredByKeyboard() throws IOException {
        Path file = visit("class Kick {\r\n    int force = 1;\r\n}\r\n");
        save("class Kick {\n    int force = 2;\n}\n");
        save("class Kick {\n    int force = 2;\n    int side = 1;\n}\n");
        write("class Kick {\n    int force = 3;\n}\n");

        openHistory();
        String versions = shown("#versions");
        browser.press("ArrowDown");
        browser.press("ArrowDown");
        String comparison = shown(".versions pre");
        browser.click("#restore-version");

        awaitSaved("class Kick {\n    int force = 1;\n}\n");
        assertThat(versions).isEqualTo("just now, 2 lines differ\njust now, 1 line differs\nearlier, 1 line differs");
        assertThat(comparison).isEqualTo("  class Kick {\n−     int force = 1;\n+     int force = 3;\n  }\n  ");
        assertThat(file).hasContent("class Kick {\r\n    int force = 1;\r\n}\r\n");
        browser.evaluate("studio.rooms.program.editor.view.focus()");
        browser.press("z", CONTROL);
        assertThat(browser.evaluate("studio.rooms.program.editor.text").getAsString())
                .contains("force = 3");
        openHistory();
        assertThat(shown("#versions")).startsWith("just now, 1 line differs\njust now, same as now");
        assertThat(browser.complaints()).isEmpty();
    }

    @Tag("slow")
    @Test
    void damagedHistoryIsReplaced() throws IOException {
        Path histories = Files.createDirectories(folder.resolve(".studio/history"));
        Files.writeString(histories.resolve("Kick.java.json"), "[{\"text\": 3}, nonsense");
        visit("class Kick {}\n");

        save("class Kick { int force; }\n");

        openHistory();
        assertThat(shown("#versions")).isEqualTo("just now, same as now\nearlier, 1 line differs");
    }

    @Tag("slow")
    @Test
    void programIsSavedWithoutPlaceForItsHistory() throws IOException {
        Files.createDirectories(folder.resolve(".studio/history/Kick.java.json/occupied"));
        Path file = visit("class Kick {}\n");

        save("class Kick { int force; }\n");
        browser.click("#program-history");

        browser.await("document.querySelector('#toast').innerText.includes('Kick.java has no saved versions yet.')");
        assertThat(file).hasContent("class Kick { int force; }\n");
    }
}
