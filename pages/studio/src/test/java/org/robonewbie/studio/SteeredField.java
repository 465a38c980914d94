package org.robonewbie.studio;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.cycle.WorldSettings;
import org.robonewbie.simulator.file.RecordingRepository;
import org.robonewbie.simulator.server.Simulator;
import org.robonewbie.simulator.server.SimulatorSettings;

/** A beginners' field in the browser at double speed, whose world waits for its first robot. */
final class SteeredField implements AutoCloseable {

    private final Chromium browser;
    private final Simulator simulator;
    private final StudioServer studio;

    SteeredField(Chromium browser, Path folder) throws IOException {
        this.browser = browser;
        this.simulator = Simulator.start(
                SimulatorSettings.of(WorldSettings.beginner().withSeed(3))
                        .withAgentPort(0)
                        .withAwaitedAgents(1)
                        .withSpeed(2),
                Console.silent());
        StudioFolders folders = new StudioFolders(
                folder.resolve("motions"), Optional.of(new RecordingRepository(folder, 1_000_000_000)));
        this.studio = StudioServer.start(simulator.control(), 0, AccessToken.random(), folders);
        visit();
    }

    Simulator simulator() {
        return simulator;
    }

    StudioServer studio() {
        return studio;
    }

    void visit() {
        browser.visit(studio.oneTimeAddress() + "&quality=lowest&theme=light");
        browser.await("studio.state.frame && studio.view.drawCalls > 0");
    }

    /** Adds the first puppet and waits until it stands behind the ball and accepts commands. */
    void addPuppet() {
        browser.await("!document.querySelector('#puppet').hidden");
        browser.click("#add-puppet");
        browser.await("studio.state.scene.robots[0]?.puppet && studio.state.frame.robots[0].torso[0] > -1");
        browser.await("studio.puppet.player"
                + " && document.querySelector('#puppet').innerText.includes('You are steering Puppets 1')");
    }

    @Override
    public void close() {
        studio.close();
        simulator.close();
    }
}
