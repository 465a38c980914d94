package org.robonewbie.learning.trial;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.MotionFile;

/** The motions that are shipped with the framework. */
public final class Library {

    private Library() {}

    /**
     * Loads a motion.
     *
     * @param name its name, such as {@code walk-forward}
     * @return the motion
     * @throws IllegalArgumentException if there is none of this name
     */
    public static Motion motion(String name) {
        return file(name).motion();
    }

    /**
     * Loads a motion with what its file says about it.
     *
     * @param name its name, such as {@code walk-forward}
     * @return the file
     * @throws IllegalArgumentException if there is none of this name
     */
    public static MotionFile file(String name) {
        String file = "/motions/" + name + ".txt";
        try (InputStream stream = Motion.class.getResourceAsStream(file)) {
            if (stream == null) {
                throw new IllegalArgumentException("There is no shipped motion \"" + name + "\".");
            }
            return MotionFile.read(name + ".txt", stream);
        } catch (IOException e) {
            throw new UncheckedIOException("Cannot read the shipped motion " + name + ".", e);
        }
    }
}
