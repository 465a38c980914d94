package org.robonewbie.studio;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.file.RecordingRepository;

/** A studio with all rooms, whose motions, recordings and programs lie in one folder. */
final class WholeStudio implements AutoCloseable {

    private static final int SHELF_BYTES = 10_000_000;

    private final StudioServer studio;

    WholeStudio(SimulationControl simulation, Path folder) throws IOException {
        ShownSimulation shown = new ShownSimulation(simulation);
        StudioFolders folders = new StudioFolders(folder, Optional.of(new RecordingRepository(folder, SHELF_BYTES)));
        studio = StudioServer.start(
                shown,
                0,
                AccessToken.random(),
                folders,
                Optional.of(new SmallCourse()),
                Optional.of(new SmallWorkshop(folder)));
    }

    /** A new address of the page, to which options and the room can be appended. */
    String oneTimeAddress() {
        return studio.oneTimeAddress().toString();
    }

    @Override
    public void close() {
        studio.close();
    }
}
