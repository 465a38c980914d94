package org.robonewbie.nao.motion;

import java.io.IOException;
import java.util.Optional;
import java.util.SortedSet;

/** A store of motion files, such as a folder or the class path. */
public interface MotionSource {

    /**
     * Reads a motion file.
     *
     * @param name the motion's name without {@code .txt}
     * @return the bytes of the file; empty if no motion has this name
     * @throws IOException if the file exists but cannot be read
     */
    Optional<byte[]> read(String name) throws IOException;

    /** {@return the names of all motions in this source, in alphabetical order} */
    SortedSet<String> names();
}
