package org.robonewbie.studio;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** A studio with content in each room: a robot on the pitch, a motion, a recording, a course, and programs. */
final class FurnishedStudio implements AutoCloseable {

    private final TestSimulator simulation = new TestSimulator().withRobot();
    private final WholeStudio studio;

    /** Starts the studio with its files in a folder: a recording named game and a motion named mine. */
    FurnishedStudio(Path folder) throws IOException {
        RecordedRun.write(folder.resolve("game.rec"));
        Files.writeString(folder.resolve("mine.txt"), "200" + " 0".repeat(22) + "\n400" + " 0".repeat(22) + "\n");
        studio = new WholeStudio(simulation.control(), folder);
    }

    /** A new address of the page, to which options and the room can be appended. */
    String oneTimeAddress() {
        return studio.oneTimeAddress();
    }

    @Override
    public void close() {
        studio.close();
        simulation.close();
    }
}
