package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** RoboNewbie as a static page, in a subfolder of a static file server. */
@InBrowser
@Timeout(300)
class WebEditionPageTest {

    private static final String CYCLE = "studio.state.frame.cycle";
    private static final String IS_PAUSED = "studio.state.frame.paused";

    private final Chromium browser;
    private StaticServer server;

    WebEditionPageTest(Chromium browser) {
        this.browser = browser;
    }

    @BeforeEach
    void open() throws IOException {
        server = new StaticServer(Path.of("target", "web").toAbsolutePath());
        browser.visit(server.address());
    }

    @AfterEach
    void end() {
        server.close();
    }

    @Test
    void agentPlaysWithoutAnyServerBehindThePage() {
        browser.await(CYCLE + " > 100");

        assertThat(browser.evaluate("studio.state.scene.robots.map(({ team, number }) => `${team} ${number}`).join()")
                        .getAsString())
                .isEqualTo("RoboNewbie 1");
        assertThat(browser.complaints()).isEmpty();
    }

    @Test
    void clockPausesStepsAndRunsFaster() {
        browser.await(CYCLE + " > 0");
        browser.click("#toggle");
        browser.await(IS_PAUSED);
        long before = cycle();

        browser.click("#step");
        browser.await(CYCLE + " === " + (before + 1));
        browser.fill("#speed", "fastest");
        browser.click("#toggle");
        browser.await(CYCLE + " > 3000");

        assertThat(browser.evaluate("studio.state.frame.speed === Infinity").getAsBoolean())
                .isTrue();
    }

    @Test
    void anotherAgentBeginsInANewWorld() {
        browser.await(CYCLE + " > 100");
        browser.fill("#page-agent", "Agent_Dance");

        browser.await(CYCLE + " < 100");

        assertThat(browser.evaluate("document.querySelectorAll('#page-agent option').length")
                        .getAsInt())
                .isGreaterThan(10);
    }

    @Test
    void fourRobotsPlayAndFromTheStartBringsThemBack() {
        browser.await(CYCLE + " > 0");
        browser.fill("#page-more", "Agent_SimpleSoccer");
        browser.fill("#page-more", "Agent_BetterSoccer");
        browser.fill("#page-more", "Agent_SimpleSoccer");
        browser.await("studio.state.scene.robots.length === 4");

        assertThat(browser.evaluate("document.querySelector('#page-more').disabled")
                        .getAsBoolean())
                .isTrue();
        browser.await(CYCLE + " > 500");
        browser.click("#page-again");
        browser.await(CYCLE + " < 400 && " + CYCLE + " > 0");
        browser.await("studio.state.scene.robots.length === 4");

        assertThat(browser.evaluate(
                                "studio.state.scene.robots.map(({ team, number }) => `${team} ${number}`).sort().join()")
                        .getAsString())
                .isEqualTo("Guests 1,Guests 2,RoboNewbie 1,RoboNewbie 2");
        assertThat(browser.complaints()).isEmpty();
    }

    @Test
    void addressNamesAllAgentsThatPlay() {
        browser.visit(server.address() + "?agent=Agent_Dance&agent=Agent_SimpleSoccer");

        browser.await("studio.state.scene?.robots.length === 2 && " + CYCLE + " > 100");

        assertThat(browser.evaluate("document.querySelector('#page-agent').value")
                        .getAsString())
                .isEqualTo("Agent_Dance");
    }

    @Test
    void robotRoomShowsWhatTheRobotSensesAndThinks() {
        browser.await(CYCLE + " > 0");

        browser.evaluate("location.hash = '#robot'");
        browser.await("document.querySelector('#robot-room').innerText.includes('Shoulder pitch')");
        browser.await("studio.robot.watch.memory.exchanges.length > 10");

        assertThat(browser.complaints()).isEmpty();
    }

    @Test
    void pageOpensWithoutANetworkOnceItWasThere() {
        browser.await(CYCLE + " > 0");
        browser.evaluate("navigator.serviceWorker.ready.then(() => true)");
        server.close();

        browser.visit(server.address());

        browser.await(CYCLE + " > 0");
    }

    @Test
    void browserWithoutGarbageCollectionShowsWhatToDo() {
        String script = browser.runBeforePages("WebAssembly.validate = () => false;");

        browser.visit(server.address() + "index.html");
        browser.await("document.body.innerText.includes('install RoboNewbie on your computer')");

        browser.forgetScript(script);
        assertThat(browser.evaluate("window.studio === undefined").getAsBoolean())
                .isTrue();
    }

    private long cycle() {
        return browser.evaluate(CYCLE).getAsLong();
    }
}
