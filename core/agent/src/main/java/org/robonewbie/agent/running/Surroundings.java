package org.robonewbie.agent.running;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.robonewbie.nao.file.PropertiesFile;

/** Environment of a program: environment variables, and properties files in the working directory. */
public final class Surroundings {

    private Surroundings() {}

    /** {@return the environment variables of this process} */
    public static Map<String, String> environment() {
        return System.getenv();
    }

    /**
     * Reads a properties file, see {@link PropertiesFile}.
     *
     * @param file its name
     * @return the values by name; empty if there is no such file
     * @throws IOException if the file is unreadable or ambiguous; the message is for users
     */
    public static Map<String, String> properties(String file) throws IOException {
        Path path = Path.of(file);
        return Files.exists(path) ? PropertiesFile.read(path) : Map.of();
    }
}
