package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.robonewbie.studio.roboviz.Datagram;
import org.robonewbie.studio.roboviz.RoboVizPort;

/** Drawings for RoboViz arrive as real datagrams and appear in the 3D view. */
@Tag("slow")
@InBrowser
class RoboVizPageTest {

    private final Chromium browser;
    private final TestSimulator simulation = new TestSimulator();
    private StudioServer studio;
    private RoboVizPort port;

    RoboVizPageTest(Chromium browser) {
        this.browser = browser;
    }

    @BeforeEach
    void open() throws IOException {
        studio = StudioServer.start(simulation.withRobot().control(), 0, AccessToken.random());
        port = RoboVizPort.open(0, studio.drawings());
        browser.visit(studio.oneTimeAddress() + "&quality=lowest&theme=light");
        browser.await("studio.state.scene?.robots.length === 1 && studio.view.drawCalls > 0");
    }

    @AfterEach
    void close() {
        port.close();
        studio.close();
        simulation.close();
    }

    private void send(Datagram datagram) throws IOException {
        byte[] bytes = datagram.done();
        try (DatagramSocket team = new DatagramSocket()) {
            InetAddress here = InetAddress.getByAddress(new byte[] {127, 0, 0, 1});
            team.send(new DatagramPacket(bytes, bytes.length, here, port.number()));
        }
    }

    @Test
    void shapesAndTextsOfTeamsAreInThePictureAndInTheListOfSets() throws IOException {
        send(new Datagram().bytes(7, 7, 7).text("nonsense"));
        send(new Datagram()
                .bytes(1, 0)
                .numbers("1.0000", "2.0000", "0.5000", "2.0000")
                .bytes(255, 0, 0)
                .text("Stars.circle")
                .bytes(2, 1, 0, 255, 255, 255)
                .text("I go to the ball")
                .bytes(0, 0)
                .text("Stars"));

        browser.await("studio.view.board.shapes.visible"
                + " && studio.view.board.shapes.geometry.attributes.position.count === 240");
        browser.await("studio.view.board.texts.children[0]?.name === 'I go to the ball'"
                + " && studio.view.board.texts.children[0].position.z > 0.6");
        browser.await("!document.querySelector('#board').hidden"
                + " && document.querySelector('#board').textContent.includes('Stars.circle')");

        browser.clickElement(
                "[...document.querySelectorAll('#board label')].find(each => each.textContent === 'Stars.circle')"
                        + "?.querySelector('input')");
        browser.await("!studio.view.board.shapes.visible && studio.view.board.texts.children.length === 1");
        assertThat(browser.complaints()).isEmpty();
    }

    @Test
    void swapWithoutShapesErases() throws IOException {
        send(new Datagram()
                .bytes(1, 3)
                .numbers("1.0000", "2.0000", "0.5000", "0.2000")
                .bytes(255, 0, 0)
                .text("a")
                .bytes(0, 0)
                .text(""));
        browser.await("studio.view.board.shapes.visible");

        send(new Datagram().bytes(0, 0).text("a"));

        browser.await("!studio.view.board.shapes.visible");
    }
}
