package org.robonewbie.app.command;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;

/**
 * The name under which the system lists this program. Tools of the league find and end their server by it, for example with
 * {@code killall rcssserver3d}, and would not find one that is called java.
 */
final class ProcessName {

    private static final Path OWN_NAME = Path.of("/proc/self/comm");

    private ProcessName() {}

    /**
     * Changes the name where the system allows it, which is Linux; elsewhere nothing happens.
     *
     * @param name the new name; Linux keeps 15 characters of it
     */
    static void set(String name) {
        try {
            if (Files.isWritable(OWN_NAME)) {
                Files.writeString(OWN_NAME, name, StandardOpenOption.WRITE);
            }
        } catch (IOException unchanged) {
            // The name only helps other tools; the simulator works under any name.
        }
    }
}
