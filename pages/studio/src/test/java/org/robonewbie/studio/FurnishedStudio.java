package org.robonewbie.studio;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.simulator.file.RecordingRepository;

/** A studio with content in each room: a robot on the pitch, a motion, a recording, a course, and programs. */
final class FurnishedStudio implements AutoCloseable {

    private static final int SHELF_BYTES = 10_000_000;

    private final TestSimulator simulation = new TestSimulator().withRobot();
    private final ShownSimulation shown = new ShownSimulation(simulation.control());
    private final SmallCourse course = new SmallCourse(shown, simulation.control());
    private final StudioServer studio;

    /** Starts the studio with its files in a folder: a recording named game and a motion named mine. */
    FurnishedStudio(Path folder) throws IOException {
        RecordedRun.write(folder.resolve("game.rec"));
        Files.writeString(folder.resolve("mine.txt"), "200" + " 0".repeat(22) + "\n400" + " 0".repeat(22) + "\n");
        StudioFolders folders = new StudioFolders(folder, Optional.of(new RecordingRepository(folder, SHELF_BYTES)));
        studio = StudioServer.start(shown, 0, AccessToken.random(), folders, course, new SmallWorkshop(folder));
    }

    /** Pauses the world, in which otherwise something always moves. */
    FurnishedStudio paused() {
        simulation.order(new Order.Pause());
        return this;
    }

    /** A new address of the page, to which options and the room can be appended. */
    String oneTimeAddress() {
        return studio.oneTimeAddress().toString();
    }

    TestSimulator simulation() {
        return simulation;
    }

    @Override
    public void close() {
        studio.close();
        course.close();
        simulation.close();
    }
}
