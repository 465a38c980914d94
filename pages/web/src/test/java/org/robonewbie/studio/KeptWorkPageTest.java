package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** No work of the user is lost in the static page: links, other windows, full storage, other editions on the same host. */
@InBrowser
@Timeout(300)
class KeptWorkPageTest {

    private static final String ROOM_IS_OPEN = "studio.rooms.program?.files?.file !== undefined";
    private static final String EDITOR = "studio.rooms.program.editor";
    private static final String NOTES = "document.querySelector('.program-notes').innerText";
    private static final String TOAST = "document.querySelector('#toast').innerText";

    @TempDir
    private Path folder;

    private final Chromium chromium;
    private StaticServer server;

    KeptWorkPageTest(Chromium chromium) {
        this.chromium = chromium;
    }

    @BeforeEach
    void serve() throws IOException {
        server = new StaticServer(Path.of("target", "web").toAbsolutePath());
    }

    @AfterEach
    void end() {
        server.close();
    }

    @Test
    void sharedProgramOpensBesideUnsavedWorkInChromium() {
        sharedProgramOpensBesideUnsavedWork(chromium);
    }

    @Test
    void sharedProgramOpensBesideUnsavedWorkInFirefox() throws IOException {
        try (Firefox firefox = Firefox.start(folder)) {
            sharedProgramOpensBesideUnsavedWork(firefox);
        }
    }

    private void sharedProgramOpensBesideUnsavedWork(AnyBrowser browser) {
        open(browser, "#program");
        browser.evaluate(EDITOR + ".replace('// unsaved')");
        browser.await(texts() + ".includes('draft:MyAgent.java=// unsaved')");

        open(browser, linkTo(browser, "MyAgent.java", "// theirs"));

        browser.await(EDITOR + ".text === '// theirs'");
        browser.await(NOTES + ".includes('This program was shared with you.')");
        assertThat(all(browser)).contains("draft:MyAgent.java=// unsaved", "draft:MyAgent2.java=// theirs");
        clickNote(browser, "Back to my program");
        browser.await(EDITOR + ".text === '// unsaved'");
        assertThat(all(browser)).doesNotContain("theirs");
    }

    @Test
    void savedWorkIsKeptWhenASharedProgramIsRunOrSaved() {
        open(chromium, "#program");
        String mine = chromium.evaluate(EDITOR + ".text").getAsString();
        chromium.click("#program-save");
        chromium.await(texts() + ".includes('file:MyAgent.java=')");

        open(chromium, linkTo(chromium, "../../MyAgent.java", mine + "// theirs"));
        chromium.await("studio.rooms.program.files.file.path === 'MyAgent2.java'");
        chromium.click("#program-run");

        chromium.await("document.querySelector('#program-room').innerText.includes('left shoulder 31.2 degrees')");
        chromium.await("!" + NOTES + ".includes('shared with you')");
        assertThat(chromium.evaluate("fetch('api/programs/own/MyAgent.java').then((answer) => answer.text())")
                        .getAsString())
                .isEqualTo(mine);
        assertThat(all(chromium)).contains("file:MyAgent2.java=");
    }

    @Test
    void changedSharedProgramIsKeptWhenOneGoesBack() {
        open(chromium, "#program");
        open(chromium, linkTo(chromium, "MyAgent.java", "// theirs"));
        chromium.await(NOTES + ".includes('shared with you')");
        chromium.evaluate(EDITOR + ".replace('// theirs, and mine')");

        clickNote(chromium, "Back to my program");

        chromium.await(texts() + ".includes('=// theirs, and mine')");
    }

    @Test
    void savedVersionIsRestoredAfterAReload() {
        open(chromium, "#program");
        for (String text : new String[] {"// first", "// second"}) {
            chromium.evaluate(EDITOR + ".replace('" + text + "')");
            chromium.click("#program-save");
            chromium.await(texts() + ".includes('file:MyAgent.java=" + text + "')");
        }

        open(chromium, "#program");
        chromium.click("#program-history");
        chromium.await("document.querySelector('#versions').options.length === 2");
        chromium.click("#restore-version");

        chromium.await(texts() + ".includes('file:MyAgent.java=// first')");
        assertThat(chromium.evaluate(EDITOR + ".text").getAsString()).isEqualTo("// first");
    }

    @Test
    void damagedLinkIsReportedAndChangesNothing() {
        open(chromium, "#program");
        String before = all(chromium);

        open(chromium, "#program?shared=rubbish");

        chromium.await(TOAST + ".includes('the link is incomplete or damaged')");
        assertThat(all(chromium)).isEqualTo(before);
    }

    @Test
    void fullStorageIsReportedAndTheTextIsKeptInChromium() {
        fullStorageIsReportedAndTheTextIsKept(chromium);
    }

    @Test
    void fullStorageIsReportedAndTheTextIsKeptInFirefox() throws IOException {
        try (Firefox firefox = Firefox.start(folder)) {
            fullStorageIsReportedAndTheTextIsKept(firefox);
        }
    }

    private void fullStorageIsReportedAndTheTextIsKept(AnyBrowser browser) {
        open(browser, "#program");
        browser.evaluate(EDITOR + ".replace('// first')");
        browser.click("#program-save");
        browser.await(texts() + ".includes('file:MyAgent.java=// first')");
        browser.evaluate("(() => { let size = 1 << 22; for (let i = 0; size > 0; i += 1) {"
                + " try { localStorage.setItem('filler' + i, 'x'.repeat(size)); }"
                + " catch { size >>= 1; } } return true; })()");

        browser.evaluate(EDITOR + ".replace('// second, and longer than the first')");
        browser.click("#program-save");

        browser.await(TOAST + ".includes('This browser has no space left for this page')");
        assertThat(browser.evaluate(EDITOR + ".text").getAsString()).isEqualTo("// second, and longer than the first");
        assertThat(browser.evaluate("studio.rooms.isAtRisk").getAsBoolean()).isTrue();
        assertThat(all(browser)).contains("file:MyAgent.java=// first");
        browser.evaluate("Object.keys(localStorage).filter((key) => key.startsWith('filler'))"
                + ".forEach((key) => localStorage.removeItem(key))");
        browser.click("#program-save");
        browser.await(texts() + ".includes('file:MyAgent.java=// second, and longer than the first')");
        assertThat(browser.evaluate("studio.rooms.isAtRisk").getAsBoolean()).isFalse();
    }

    @Test
    void unsavedWorkOfAnotherWindowIsNeitherReplacedNorRemoved() {
        open(chromium, "#program");
        String draft =
                "localStorage.getItem(new URL('.', location.href).pathname + 'robonewbie-page-draft:MyAgent.java')";
        chromium.evaluate("localStorage.setItem(new URL('.', location.href).pathname"
                + " + 'robonewbie-page-draft:MyAgent.java', '// of the other window')");

        chromium.evaluate(EDITOR + ".replace('// of this window')");
        chromium.await(NOTES + ".includes('Another window also has unsaved changes to MyAgent.java.')");
        assertThat(chromium.evaluate("studio.rooms.isAtRisk").getAsBoolean()).isTrue();
        chromium.click("#program-save");

        chromium.await(texts() + ".includes('file:MyAgent.java=// of this window')");
        assertThat(chromium.evaluate(draft).getAsString()).isEqualTo("// of the other window");
    }

    @Test
    void editionsOnOneHostHaveSeparateStoragesAndMigrateOldData() throws IOException {
        Path page = Path.of("target", "web").toAbsolutePath();
        for (String edition : new String[] {"2025", "2026"}) {
            Files.createSymbolicLink(folder.resolve(edition), page);
        }
        try (StaticServer host = new StaticServer(folder)) {
            chromium.visit(host.address() + "2025/icon.svg");
            chromium.evaluate("localStorage.setItem('robonewbie-page-file:Old.java', '// kept by the first edition')");
            chromium.evaluate("caches.open('robonewbie-0123456789abcdef')" + ".then((cache) => cache.put('"
                    + host.address() + "2025/', new Response('old')))");
            for (String edition : new String[] {"2025", "2026"}) {
                chromium.visit(host.address() + edition + "/#program");
                chromium.await(ROOM_IS_OPEN);
                chromium.evaluate("navigator.serviceWorker.ready.then(() => true)");
                chromium.evaluate("fetch('api/programs/own/Only" + edition
                        + ".java', { method: 'PUT', body: '//' }).then(() => true)");
            }

            assertThat(chromium.evaluate("fetch('api/programs').then((answer) => answer.json())"
                                    + ".then(({ own }) => own.map(({ path }) => path).join())")
                            .getAsString())
                    .isEqualTo("Old.java,Only2026.java");
            assertThat(chromium.evaluate(
                                    "caches.keys().then((keys) => keys.map((key) => key.replace(/[\\w-]+$/, '')).join())")
                            .getAsString())
                    .isEqualTo("robonewbie /some/where/2025/ ,robonewbie /some/where/2026/ ");
        }
    }

    private void open(AnyBrowser browser, String place) {
        browser.visit("about:blank");
        browser.visit(server.address() + place);
        browser.await(ROOM_IS_OPEN);
    }

    private static String linkTo(AnyBrowser browser, String path, String text) {
        return "#"
                + browser.evaluate("import('./page/share.js').then(({ sharedHash }) => sharedHash("
                                + Chromium.quoted(path) + ", " + Chromium.quoted(text) + "))")
                        .getAsString();
    }

    private static void clickNote(AnyBrowser browser, String name) {
        browser.evaluate("[...document.querySelectorAll('.program-notes button')]"
                + ".find((each) => each.innerText === '" + name + "').click()");
    }

    /** Expression for all stored texts, each as KIND:NAME=TEXT. */
    private static String texts() {
        return "Object.entries(localStorage).filter(([key]) => key.includes('robonewbie-page-'))"
                + ".map(([key, text]) => key.replace(/.*robonewbie-page-/, '') + '=' + text).sort().join('\\n')";
    }

    private static String all(AnyBrowser browser) {
        return browser.evaluate(texts()).getAsString();
    }
}
