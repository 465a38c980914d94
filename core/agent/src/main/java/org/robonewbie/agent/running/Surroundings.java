package org.robonewbie.agent.running;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.robonewbie.nao.file.PropertiesFile;

/** What a program finds around itself: environment variables, and properties in files of the working directory. */
public final class Surroundings {

    private Surroundings() {}

    /** {@return the environment variables of this process} */
    public static Map<String, String> environment() {
        return System.getenv();
    }

    /**
     * Reads a file of properties, see {@link PropertiesFile}.
     *
     * @param file its name
     * @return value by name; empty if there is no such file
     * @throws IOException if the file cannot be read or is not clear; the message is for users
     */
    public static Map<String, String> properties(String file) throws IOException {
        Path path = Path.of(file);
        return Files.exists(path) ? PropertiesFile.read(path) : Map.of();
    }
}
