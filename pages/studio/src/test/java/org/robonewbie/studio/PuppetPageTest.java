package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.monitor.FoulType;
import org.robonewbie.simulator.server.Simulator;
import org.robonewbie.simulator.soccer.MatchEvent;

/** Use without programming: steer a robot with keys and sliders, save a scene and restore it. */
@Tag("slow")
@InBrowser
class PuppetPageTest {

    private static final String SLIDER =
            "document.querySelector('#puppet-joints input[data-joint=LEFT_SHOULDER_PITCH]')";
    private static final String ANGLE = "studio.state.frame.robots[0].degrees[studio.state.scene.models.TYPE_0.hinges"
            + ".findIndex(hinge => hinge.joint === 'LEFT_SHOULDER_PITCH')]";

    @TempDir
    private Path folder;

    private final Chromium browser;
    private SteeredField field;

    PuppetPageTest(Chromium browser) {
        this.browser = browser;
    }

    @BeforeEach
    void open() throws IOException {
        RecordedRun.write(folder.resolve("game.rec"));
        field = new SteeredField(browser, folder);
    }

    @AfterEach
    void close() {
        field.close();
    }

    @Test
    void keyLetsThePuppetWalkWhileItIsHeld() {
        field.addPuppet();
        double start = browser.evaluate("studio.state.frame.robots[0].torso[0]").getAsDouble();

        browser.evaluate("document.dispatchEvent(new KeyboardEvent('keydown', {key: 'w', bubbles: true}))");
        browser.await("studio.state.frame.robots[0].torso[0] > " + (start + 0.3));
        browser.evaluate("document.dispatchEvent(new KeyboardEvent('keyup', {key: 'w', bubbles: true}))");

        browser.await("(window.places ??= []).push(studio.state.frame.robots[0].torso[0]) > 60"
                + " && Math.abs(places.at(-1) - places.at(-20)) < 0.005");
        assertThat(browser.complaints()).isEmpty();
    }

    @Test
    void puppetAppearsBehindTheBallWithItsJointsInReach() {
        browser.evaluate(
                "(() => { window.fromPlace = 9; setInterval(() => { const { robots, ball } = studio.state.frame ??"
                        + " { robots: [] }; if (robots[0]) window.fromPlace = Math.min(fromPlace, Math.hypot(robots[0].torso[0]"
                        + " - ball[0] + 0.4, robots[0].torso[1] - ball[1])); }, 20); })()");

        field.addPuppet();

        browser.await("fromPlace < 0.1");
        browser.click("#side-fold");
        browser.click("#puppet-joints summary");
        browser.await("document.querySelector('#puppet-joints input')");
        browser.await("(() => { const slider = document.querySelector('#puppet-joints input').getBoundingClientRect();"
                + " const side = document.querySelector('#side').getBoundingClientRect();"
                + " return slider.top > side.top && slider.bottom < Math.min(side.bottom, innerHeight); })()");
    }

    @Test
    void resetFreesTheNamesOfTeamsThatHaveLeft() throws IOException {
        field.addPuppet();
        browser.click("#remove-puppet");
        browser.await("studio.state.scene.robots.length === 0");

        browser.click("#reset");
        browser.await("studio.state.scene.teams.left === ''");
        new Stranger(field.simulator(), "Stars").join();
        new Stranger(field.simulator(), "Moons").join();
        browser.await("studio.state.scene.teams.left === 'Stars' && studio.state.scene.teams.right === 'Moons'");
        new Stranger(field.simulator(), "Suns").join();
        browser.await("document.querySelector('#toast').textContent.includes('no room for team \"Suns\"')");
    }

    @Test
    void hintNamesThePortAtWhichAgentsJoin() {
        browser.await(
                "document.querySelector('#banner').innerText.includes('./robonewbie run Agent_BasicStructure --port "
                        + field.simulator().agentPort() + "')");
    }

    /** A foreign robot that stays until the simulator ends. */
    private static final class Stranger {

        private final AgentLink link;
        private final String team;

        Stranger(Simulator simulator, String team) {
            this.link = simulator.connect();
            this.team = team;
        }

        void join() throws IOException {
            say("(scene rsg/agent/nao/nao.rsg)(syn)");
            link.receive(new MessageBuffer());
            say("(init (unum 1)(teamname " + team + "))(syn)");
            Thread life = new Thread(this::live, team);
            life.setDaemon(true);
            life.start();
        }

        private void live() {
            MessageBuffer heard = new MessageBuffer();
            try {
                while (link.receive(heard)) {
                    say("(syn)");
                }
            } catch (IOException simulatorHasEnded) {
                link.close();
            }
        }

        private void say(String text) throws IOException {
            MessageBuffer message = new MessageBuffer();
            message.append(text);
            link.send(message);
        }
    }

    @Test
    void sceneIsRenamedDeletedAndRestored() {
        field.addPuppet();
        browser.fill("#scene-name", "Before the kick");
        browser.click("#scene-save");
        browser.await("document.querySelector('#scene-list').value === 'Before the kick'");

        browser.fill("#scene-name", "Free kick");
        browser.click("#scene-rename");
        browser.await("document.querySelector('#scene-list').value === 'Free kick'");
        browser.click("#scene-remove");
        browser.await("document.querySelector('#scene-list').options.length === 0");
        browser.await("document.querySelector('#world-undo').title.includes('scene \"Free kick\" deleted')");
        browser.click("#world-undo");
        browser.await("document.querySelector('#scene-list').value === 'Free kick'");
        browser.await("document.querySelector('#world-undo').title.includes('renamed')");
        browser.click("#world-undo");
        browser.await("document.querySelector('#scene-list').value === 'Before the kick'");
        browser.click("#world-redo");
        browser.await("document.querySelector('#scene-list').value === 'Free kick'");

        assertThat(browser.complaints()).isEmpty();
    }

    @Test
    void sliderMovesAnArmAndASceneKeepsIt() {
        field.addPuppet();
        raiseTheArm();
        browser.fill("#scene-name", "Arm up");
        browser.click("#scene-save");
        browser.await("document.querySelector('#scene-list').value === 'Arm up'");
        browser.evaluate(SLIDER + ".value = '0'; " + SLIDER + ".dispatchEvent(new Event('input'))");
        browser.await(ANGLE + " < 2");
        browser.click("#scene-restore");

        browser.await("studio.state.frame.paused && " + ANGLE + " > 78");
        browser.await("document.body.innerText.includes('The world was restored exactly.')");
        assertThat(browser.complaints()).isEmpty();
    }

    private void raiseTheArm() {
        browser.evaluate("document.querySelector('#puppet-joints').open = true");
        browser.await(SLIDER);
        browser.evaluate(SLIDER + ".value = '80'; " + SLIDER + ".dispatchEvent(new Event('input'))");
        browser.await(ANGLE + " > 78");
    }

    @Test
    void takesScreenshotOfAPuppet() throws IOException {
        browser.drawSharply();
        field.visit();
        field.addPuppet();
        raiseTheArm();

        Picture.keep("studio-puppet.png", browser.screenshot());
        assertThat(browser.complaints()).isEmpty();
    }

    @Test
    void recordingContinuesFromTheShownCycle() {
        browser.evaluate("location.hash = '#replay/game'");
        browser.await("studio.replay?.file?.isWhole");
        browser.evaluate("studio.replay.actions.find(action => action.shown === 'End').act()");
        browser.click("#start-here");

        browser.await("location.hash === '#field' && !studio.cursor.recorded && studio.state.frame?.paused"
                + " && studio.state.frame.robots[0]?.torso[2] < 0.25");
        browser.await("document.body.innerText.includes('The world was restored only approximately')");
        browser.await("document.querySelector('.team.left').textContent === 'Ada'");
        browser.await("document.querySelector('.score').textContent.replace(/\\s/g, '') === '1:0'");
    }

    @Test
    void foulIsShownBesideTheScore() {
        field.addPuppet();
        browser.evaluate("new MutationObserver(() => { window.matchEvents = (window.matchEvents ?? '')"
                + " + document.querySelector('.event-list').innerText; })"
                + ".observe(document.querySelector('.event-list'), {childList: true})");

        field.studio().feed().happened(new MatchEvent.FoulCalled(FoulType.CHARGING, TeamSide.LEFT, 1));

        browser.await("window.matchEvents?.includes('Foul: Puppets 1 runs into an opponent')");
    }
}
