package org.robonewbie.nao.motion;

import java.io.IOException;
import java.util.Optional;
import java.util.SortedSet;

/** A place that keeps motion files: a folder, the class path, memory. */
public interface MotionSource {

    /**
     * Reads a motion file.
     *
     * @param name the motion's name without {@code .txt}
     * @return the bytes of the file; empty if there is none of this name
     * @throws IOException if the file exists but cannot be read
     */
    Optional<byte[]> read(String name) throws IOException;

    /** {@return the names of all motions of this source in alphabetical order} */
    SortedSet<String> names();
}
