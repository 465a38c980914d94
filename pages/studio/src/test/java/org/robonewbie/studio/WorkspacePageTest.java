package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.model.RobotType;

/** Layout of 3D view and panels: edges are moved by mouse and keys, a menu shows or hides panels, and the browser remembers it. */
@Tag("slow")
@InBrowser(width = 1440, height = 900)
class WorkspacePageTest {

    private static final String PICTURE_WIDTH = "document.querySelector('#stage').clientWidth";
    private static final String EDGE = "document.querySelector('.edge[aria-orientation=vertical]')";

    private final Chromium browser;
    private final TestSimulator simulation = new TestSimulator();
    private StudioServer studio;

    WorkspacePageTest(Chromium browser) {
        this.browser = browser;
    }

    @BeforeEach
    void openRobotRoom() throws IOException {
        studio = StudioServer.start(simulation.withRobot().control(), 0, AccessToken.random());
        open("#robot");
        browser.await("document.querySelectorAll('.joint-row').length > 20 && " + EDGE);
    }

    @AfterEach
    void close() {
        studio.close();
        simulation.close();
    }

    private void open(String room) {
        browser.visit(studio.oneTimeAddress() + "&theme=light&quality=lowest" + room);
        browser.await("studio.state.frame && studio.view.drawCalls > 0");
    }

    private int pictureWidth() {
        return browser.evaluate(PICTURE_WIDTH).getAsInt();
    }

    @Test
    void edgeIsDraggedAndKeepsItsPosition() {
        int before = pictureWidth();
        double x = browser.evaluate(EDGE + ".getBoundingClientRect().left").getAsDouble() + 4;

        browser.mouse("mouseMoved", x, 300);
        browser.mouse("mousePressed", x, 300);
        browser.mouse("mouseMoved", x + 60, 300);
        browser.mouse("mouseMoved", x + 120, 300);
        browser.mouse("mouseReleased", x + 120, 300);

        browser.await("Math.abs(" + PICTURE_WIDTH + " - " + (before + 120) + ") < 6");
        int after = pictureWidth();
        open("#robot");
        browser.await(EDGE + " && Math.abs(" + PICTURE_WIDTH + " - " + after + ") < 3");
        assertThat(browser.complaints()).isEmpty();
    }

    @Test
    void edgeIsMovedByArrowKeysAndADoubleClickPutsItBack() {
        int before = pictureWidth();
        String value = EDGE + ".ariaValueNow";
        int percent = browser.evaluate("Number(" + value + ")").getAsInt();

        browser.evaluate(EDGE + ".focus()");
        browser.press("ArrowLeft");
        browser.press("ArrowLeft");

        browser.await(PICTURE_WIDTH + " < " + (before - 60) + " && Number(" + value + ") < " + percent);
        browser.evaluate(EDGE + ".dispatchEvent(new MouseEvent('dblclick'))");
        browser.await("Math.abs(" + PICTURE_WIDTH + " - " + before + ") < 3");
    }

    @Test
    void menuShowsAndHidesThePanelsOfTheRoom() {
        String joints = "document.querySelector('#robot-joints')";
        browser.click("#panels-button");
        browser.await("document.querySelector('#panel-joints').checkVisibility()"
                + " && document.querySelector('#panel-joints').checked");

        browser.click("#panel-joints");

        browser.await("!" + joints + ".checkVisibility()");
        open("#robot");
        browser.await("document.querySelector('#robot-curves .plot-row') && !" + joints + ".checkVisibility()");
        browser.click("#panels-button");
        browser.clickElement("document.querySelector('#panels button')");
        browser.await(joints + ".checkVisibility()");
    }

    @Test
    void panelOfTheRobotIsAddedToTheField() {
        open("#field");
        browser.await(PICTURE_WIDTH + " === innerWidth");

        browser.click("#panels-button");
        browser.click("#panel-curves");

        browser.await("document.querySelectorAll('#robot-curves .plot-row').length > 0 && " + PICTURE_WIDTH
                + " < innerWidth - 200 && location.hash === '#field'");
        assertThat(browser.complaints()).isEmpty();
    }

    @Test
    void robotThatIsChosenInThePictureIsTheOneInThePanels() {
        simulation.withRobot(RobotType.TYPE_0, TeamSide.RIGHT, 4, 1, 1, 180, Posture.STANDING);
        browser.await("document.querySelector('#robot-choice').options.length === 2");

        browser.evaluate("studio.camera.choose(1); studio.touch()");
        browser.await("document.querySelector('#robot-choice').value === '1'");
        browser.press("n");

        browser.await("document.querySelector('#robot-choice').value === '0' && studio.camera.chosen === 0");
    }

    @Test
    void toolsOverThePictureAreFoldedUntilTheyAreNeeded() {
        open("#field");
        browser.await("!document.querySelector('#trainer').checkVisibility()"
                + " && document.querySelector('#side-fold').ariaExpanded === 'false'");

        browser.click("#side-fold");

        browser.await("document.querySelector('#trainer').checkVisibility()");
        open("#field");
        browser.await("document.querySelector('#trainer').checkVisibility()");
    }
}
