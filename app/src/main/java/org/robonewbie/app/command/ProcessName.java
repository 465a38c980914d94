package org.robonewbie.app.command;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;

/**
 * Name of this process in the system's process list. League tools find and stop the server by this name, for example with
 * {@code killall rcssserver3d}, and would not find a process named java.
 */
final class ProcessName {

    private static final Path OWN_NAME = Path.of("/proc/self/comm");

    private ProcessName() {}

    /**
     * Sets the name on Linux; does nothing on other systems.
     *
     * @param name the new name, of which Linux keeps 15 characters
     */
    static void set(String name) {
        try {
            if (Files.isWritable(OWN_NAME)) {
                Files.writeString(OWN_NAME, name, StandardOpenOption.WRITE);
            }
        } catch (IOException unchanged) {
            // only other tools need the name
        }
    }
}
