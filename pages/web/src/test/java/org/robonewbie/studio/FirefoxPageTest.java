package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonPrimitive;
import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Exercises;
import org.robonewbie.web.Solutions;

/** The static page in a real Firefox: opened once, then without its server. */
@Timeout(600)
class FirefoxPageTest {

    private static final String SHOWN = "document.querySelector('#program-room').innerText";
    private static final String ROOM_IS_OPEN = "studio.rooms.program?.files?.file !== undefined";

    /** Waits until the compiler is cached for offline use. */
    private static final String IS_KEPT = "new Promise((done) => { const look = async () => {"
            + " const kept = await Promise.all(['compiler/javac.wasm', 'compiler/library.bin',"
            + " 'programs/robonewbie.wasm', 'vendor/codemirror/codemirror.js'].map((name) => caches.match(name)));"
            + " if (kept.every(Boolean)) { done(true); } else { setTimeout(look, 50); } }; look(); })";

    @TempDir
    private Path profile;

    private StaticServer server;
    private Firefox browser;

    @BeforeEach
    void open() throws IOException {
        browser = Firefox.start(profile);
        server = new StaticServer(Path.of("target", "web").toAbsolutePath());
    }

    @AfterEach
    void end() {
        if (browser != null) { // null without Firefox; the test is then skipped
            browser.close();
            server.close();
        }
    }

    @Test
    void programIsWrittenRunAndJudgedWithoutANetwork() throws IOException {
        String page = server.address() + "#program";
        browser.visit(page);
        browser.await(ROOM_IS_OPEN);
        browser.evaluate("navigator.serviceWorker.ready.then(() => true)");
        browser.click("#program-run");
        browser.await(SHOWN + ".includes('left shoulder 31.2 degrees')");
        browser.evaluate(IS_KEPT);
        server.close();

        browser.visit(page);
        browser.await(ROOM_IS_OPEN);
        write("public class MyAgent extends org.robonewbie.agent.Agent {\n  protected void think() {\n    \n  }\n}\n");
        browser.evaluate(
                "(({ view }) => { view.focus();"
                        + " view.dispatch({ selection: { anchor: view.state.doc.line(3).to } }); })(studio.rooms.program.editor)");
        browser.type("nao.sayy(\"x\");");
        browser.await(SHOWN + ".includes('cannot find symbol')");
        assertThat(browser.evaluate("document.querySelector('#program-remarks').innerText")
                        .getAsString())
                .contains("3");

        solve(Exercises.all().get(0));
        browser.close();
        browser = Firefox.start(profile);
        browser.visit(page);
        browser.await(ROOM_IS_OPEN);
        assertThat(browser.evaluate("fetch('api/programs').then((answer) => answer.json())"
                                + ".then(({ own }) => own.map(({ path }) => path).join())")
                        .getAsString())
                .isEqualTo("MyAgent.java,RaiseArms.java");
        browser.await("studio.rooms.program.editor.text.includes('class RaiseArms')");
    }

    private void solve(Exercise first) {
        browser.evaluate("location.hash = '#program/" + first.name() + "'");
        browser.await("studio.rooms.program.files.file?.path === '" + first.fileName() + "'");
        write(Solutions.text(first));
        browser.click("#program-check");
        browser.await(SHOWN + ".includes('Passed: 10.0 of 10 points')");
    }

    private void write(String text) {
        browser.evaluate("studio.rooms.program.editor.replace(" + new JsonPrimitive(text) + ")");
    }

    @Test
    void browserWithoutGarbageCollectionShowsWhatToDo() throws IOException {
        browser.close();
        browser = Firefox.start(profile, "user_pref(\"javascript.options.wasm\", false);");

        browser.visit(server.address());

        browser.await("document.body.innerText.includes('install RoboNewbie on your computer')");
    }
}
