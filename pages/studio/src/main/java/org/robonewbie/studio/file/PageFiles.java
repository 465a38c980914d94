package org.robonewbie.studio.file;

import java.io.IOException;
import java.util.List;
import java.util.Optional;

/** Files of one kind, such as programs or drafts of motions, that pages list, read and perhaps change. */
public interface PageFiles {

    /**
     * A file.
     *
     * @param path its path as used by pages
     * @param version its {@link FileVersion}; empty for a file that cannot be changed
     */
    record Entry(String path, String version) {}

    /**
     * All files.
     *
     * @param folder where they are; empty if that is of no interest
     * @param files the files in alphabetical order
     * @param leftOut a message for each file that was omitted and that the user should know about
     */
    record Listing(String folder, List<Entry> files, List<String> leftOut) {}

    /** {@return the noun for one of these files in messages, such as "motion"} */
    String kind();

    /**
     * {@return all files}
     *
     * @throws IOException if the folder cannot be read
     */
    Listing list() throws IOException;

    /**
     * Reads a file.
     *
     * @param path path as used by pages
     * @return the contents; empty if there is no such file
     * @throws IOException if it cannot be read
     * @throws RefusedException if the path is not allowed
     */
    Optional<byte[]> read(String path) throws IOException;

    /** {@return the maximum size of a file in bytes; 0 if pages cannot write any} */
    default int maxBytes() {
        return 0;
    }

    /**
     * Writes a file. By default, this is refused.
     *
     * @param path path as used by pages
     * @param content the new contents
     * @param knownVersion the version that the page has read, empty for a new file
     * @return the new version
     * @throws IOException if it cannot be written
     * @throws RefusedException if the path is not allowed, or the file has a version that the page has not read
     */
    default String write(String path, byte[] content, Optional<String> knownVersion) throws IOException {
        throw new RefusedException(405, "A " + kind() + " cannot be changed here.");
    }

    /**
     * Deletes a file if it exists. By default, this is refused.
     *
     * @param path path as used by pages
     * @param version the version to delete, any other is kept; if there is none, any version is deleted
     * @throws IOException if it cannot be deleted
     * @throws RefusedException if the path is not allowed
     */
    default void remove(String path, Optional<String> version) throws IOException {
        throw new RefusedException(405, "A " + kind() + " cannot be deleted here.");
    }
}
