package org.robonewbie.studio.replay;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import org.robonewbie.simulator.file.RecordingAbout;

/** Storage of recordings. */
public interface RecordingStore {

    /**
     * Lists the recordings.
     *
     * @return all recordings in display order
     * @throws IOException if they cannot be read
     */
    List<RecordingEntry> all() throws IOException;

    /** {@return the folder of new recordings, shown to the user; empty for none} */
    Optional<String> folder();

    /**
     * Replaces the metadata of a recording.
     *
     * @param name its name
     * @param about the new metadata
     * @throws IOException if it cannot be written
     */
    void write(String name, RecordingAbout about) throws IOException;

    /**
     * Renames a recording.
     *
     * @param from its name
     * @param to a valid, unused name
     * @throws IOException if it cannot be renamed
     */
    void rename(String from, String to) throws IOException;

    /**
     * Deletes a recording; it can be restored for at least an hour.
     *
     * @param name its name
     * @throws IOException if it cannot be deleted
     */
    void remove(String name) throws IOException;

    /**
     * Restores a deleted recording.
     *
     * @param name its name when it was deleted
     * @return whether it has been restored; false if it was deleted too long ago
     * @throws IOException if it cannot be restored
     */
    boolean bringBack(String name) throws IOException;

    /**
     * Continues reading a recording.
     *
     * @param name its name
     * @param milliseconds time limit for this call
     * @return everything that has been read so far
     * @throws IOException if it cannot be read
     * @throws IllegalArgumentException if it is not a recording
     */
    RunReading read(String name, long milliseconds) throws IOException;
}
