package org.robonewbie.simulator.file;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.robonewbie.nao.file.AtomicFile;
import org.robonewbie.simulator.state.WorldState;

/** Reads and writes saved world states. */
public final class StateFile {

    /** Extension of files with a saved state. */
    public static final String ENDING = ".state";

    private StateFile() {}

    /**
     * Writes a state atomically; an existing file is replaced.
     *
     * @param state the state
     * @param file the file
     * @throws IOException if it cannot be written; the message says what to do
     */
    public static void write(WorldState state, Path file) throws IOException {
        AtomicFile.write(file, state.toBytes());
    }

    /**
     * Reads a state.
     *
     * @param file the file
     * @return the state
     * @throws IOException if it cannot be read
     * @throws IllegalArgumentException if the file is damaged or is not a state in this format version; the message
     *     contains the file name and the byte offset
     */
    public static WorldState read(Path file) throws IOException {
        try {
            return WorldState.ofBytes(Files.readAllBytes(file));
        } catch (IllegalArgumentException damaged) {
            throw new IllegalArgumentException(file + ": " + damaged.getMessage(), damaged);
        }
    }
}
