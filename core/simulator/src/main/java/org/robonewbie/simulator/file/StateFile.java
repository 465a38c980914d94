package org.robonewbie.simulator.file;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.robonewbie.nao.file.AtomicFile;
import org.robonewbie.simulator.state.WorldState;

/** The state of a world as a file. */
public final class StateFile {

    /** How the names of these files end. */
    public static final String ENDING = ".state";

    private StateFile() {}

    /**
     * Writes a state, as a whole or not at all; a file of the same name is replaced.
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
     * @throws IllegalArgumentException if it is no state, of another version, or damaged; the message names file and byte
     */
    public static WorldState read(Path file) throws IOException {
        try {
            return WorldState.ofBytes(Files.readAllBytes(file));
        } catch (IllegalArgumentException damaged) {
            throw new IllegalArgumentException(file + ": " + damaged.getMessage(), damaged);
        }
    }
}
