package org.robonewbie.web;

import java.io.IOException;
import java.io.UncheckedIOException;
import org.robonewbie.agent.NaoDriver;
import org.robonewbie.agent.Options;
import org.robonewbie.agent.StartUpException;
import org.robonewbie.agent.puppet.SteeredRobot;
import org.robonewbie.protocol.telemetry.TelemetrySink;

/** A manually controlled robot in a world that is advanced elsewhere. */
final class PagePuppet extends SteeredRobot {

    private final PatientLink link;
    private final NaoDriver driver;
    private Runnable onClosed = () -> {};

    /**
     * Lets the robot join, and advances the world until the robot is standing.
     *
     * @param link the robot's end of the connection
     * @param options identity of the robot
     * @throws IllegalStateException if the robot cannot join; the message gives the reason
     */
    PagePuppet(PatientLink link, Options options) {
        this.link = link;
        try {
            driver = NaoDriver.enter(link, options, TelemetrySink.NONE);
        } catch (StartUpException refused) {
            link.close();
            throw new IllegalStateException(refused.getMessage(), refused);
        } catch (IOException impossible) {
            throw new UncheckedIOException("The simulator on this page has closed the connection.", impossible);
        }
        link.stopWaiting();
        begin(driver.nao());
    }

    /**
     * Sets the listener for the end of the connection.
     *
     * @param newListener called after the connection has been closed
     */
    void whenLeft(Runnable newListener) {
        onClosed = newListener;
    }

    /** Responds to the pending message, if any. */
    void turn() {
        if (link.isMessageWaiting() && driver.nao().sense()) {
            move(driver.nao());
            driver.complete();
        }
    }

    @Override
    public void close() {
        link.close();
        onClosed.run();
    }
}
