package org.robonewbie.web;

import java.io.IOException;
import java.io.UncheckedIOException;
import org.robonewbie.agent.NaoDriver;
import org.robonewbie.agent.Options;
import org.robonewbie.agent.StartUpException;
import org.robonewbie.agent.puppet.SteeredRobot;
import org.robonewbie.protocol.telemetry.TelemetrySink;

/** A robot that is steered by hand, in a world that somebody else turns. */
final class PagePuppet extends SteeredRobot {

    private final PatientLink link;
    private final NaoDriver driver;
    private Runnable farewell = () -> {};

    /**
     * Lets the robot enter, which turns the world until it stands.
     *
     * @param link the robot's end of the connection
     * @param options who it is
     * @throws IllegalStateException if the world does not let it in; the message says why
     */
    PagePuppet(PatientLink link, Options options) {
        this.link = link;
        try {
            driver = NaoDriver.enter(link, options, TelemetrySink.NONE);
        } catch (StartUpException refused) {
            link.close();
            throw new IllegalStateException(refused.getMessage(), refused);
        } catch (IOException impossible) {
            throw new UncheckedIOException("The world of the page has closed its connection.", impossible);
        }
        link.beBusy();
        begin(driver.nao());
    }

    /**
     * Names a listener for the robot's leave-taking.
     *
     * @param newListener called when it has closed its connection
     */
    void whenLeft(Runnable newListener) {
        farewell = newListener;
    }

    /** Answers the message that is there. */
    void goOn() {
        if (link.isMessageWaiting() && driver.nao().sense()) {
            move(driver.nao());
            driver.complete();
        }
    }

    @Override
    public void close() {
        link.close();
        farewell.run();
    }
}
