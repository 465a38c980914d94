package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Motions in the static page: the browser stores them, and a robot with weight plays them. */
@InBrowser
@Timeout(300)
class MotionInThePageTest {

    private static final String EDITOR = "studio.motion.editor";
    private static final String TWO_KEYFRAMES = """
            500 0 0 -90 10 0 -25 0 0 25 -50 25 0 0 0 25 -50 25 0 -90 -10 0 25
            1000 0 12.5 -90 10 0 -25 0 0 25 -50 25 0 0 0 25 -50 25 0 -90 -10 0 25
            """;

    private final Chromium browser;
    private StaticServer server;

    MotionInThePageTest(Chromium browser) {
        this.browser = browser;
    }

    @BeforeEach
    void open() throws IOException {
        server = new StaticServer(Path.of("target", "web").toAbsolutePath());
        browser.visit(server.address());
        browser.await("studio.state.frame.cycle > 0");
    }

    @AfterEach
    void end() {
        server.close();
    }

    @Test
    void motionOfTheLibraryIsPlayedByARobotWithWeight() {
        enter("wave");

        browser.evaluate("fetch('library/wave.txt').then((answer) => answer.text()).then((text) => fetch('api/trial',"
                + " { method: 'POST', body: text, headers: { Start: 'standing' } })).then((answer) => answer.json())"
                + ".then((trial) => { window.trial = trial; })");

        assertThat(browser.evaluate("trial.frames.length").getAsInt()).isGreaterThan(20);
        assertThat(browser.evaluate("trial.fallSeconds === undefined").getAsBoolean())
                .isTrue();
        assertThat(browser.complaints()).isEmpty();
    }

    @Test
    void ownMotionAndUnsavedWorkAreThereAgain() {
        assertThat(browser.evaluate(
                                "fetch('api/motions/mine', { method: 'PUT', headers: { 'Known-Version': '' }, body: "
                                        + Chromium.quoted(TWO_KEYFRAMES) + " }).then(({ ok }) => ok)")
                        .getAsBoolean())
                .isTrue();
        enter("mine");
        browser.fill("[data-joint='NECK_PITCH']", "7.5");
        browser.await("Object.keys(localStorage).some((key) => key.endsWith('robonewbie-page-motion-draft:mine'))");

        browser.visit("about:blank");
        browser.visit(server.address());
        enter("mine");

        browser.await(
                EDITOR + ".state.history.present.value.lines.filter((line) => line.keyframe)[0].keyframe.degrees[1]"
                        + " === 7.5");
    }

    @Test
    void programStartsAMotionThatWasMadeInThePage() {
        keep("mine", TWO_KEYFRAMES);
        browser.evaluate("location.hash = '#program'");
        browser.await("studio.rooms.program?.files?.file !== undefined");
        browser.evaluate("studio.rooms.program.editor.replace(" + Chromium.quoted("""
                import org.robonewbie.agent.Agent;
                import org.robonewbie.nao.Joint;
                public class MyAgent extends Agent {
                    protected void think() {
                        motions.start("mine");
                        log.info("neck %.1f", nao.getJointAngle(Joint.NECK_PITCH));
                    }
                }
                """) + ")");
        browser.click("#program-run");
        browser.await("document.querySelector('#program-log').innerText.includes('neck 12.5')");

        keep("mine", TWO_KEYFRAMES.replace("12.5", "-9.5"));

        browser.await("document.querySelector('#program-log').innerText.includes('neck -9.5')");
        assertThat(browser.complaints()).isEmpty();
    }

    private void keep(String motion, String text) {
        browser.evaluate("fetch('api/motions/" + motion + "').then((answer) => fetch('api/motions/" + motion
                + "', { method: 'PUT', headers: { 'Known-Version': answer.headers.get('Version') ?? '' }, body: "
                + Chromium.quoted(text) + " })).then((answer) => { if (!answer.ok) throw new Error(answer.status); })");
    }

    private void enter(String motion) {
        browser.evaluate("location.hash = '#motion/" + motion + "'");
        browser.await(EDITOR + ".state.name === '" + motion + "'");
    }
}
