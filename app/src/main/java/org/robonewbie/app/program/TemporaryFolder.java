package org.robonewbie.app.program;

import java.io.IOException;
import java.nio.file.Path;
import org.robonewbie.competition.team.TeamFolder;
import org.robonewbie.nao.file.TemporaryFiles;

/**
 * A folder that is gone with all of its files when it is closed.
 *
 * @param path the folder
 */
public record TemporaryFolder(Path path) implements AutoCloseable {

    /**
     * Makes an empty folder.
     *
     * @param name how its name begins
     * @return the folder
     * @throws IOException if the system's folder for temporary files cannot be written
     */
    public static TemporaryFolder create(String name) throws IOException {
        return new TemporaryFolder(TemporaryFiles.folder(name));
    }

    @Override
    public void close() {
        TeamFolder.delete(path);
    }
}
