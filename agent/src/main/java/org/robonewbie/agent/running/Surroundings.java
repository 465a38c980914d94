package org.robonewbie.agent.running;

import java.io.IOException;
import java.io.Reader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Properties;

/** What a program finds around itself: environment variables, and properties in files of the working directory. */
public final class Surroundings {

    private Surroundings() {}

    /** {@return the environment variables of this process} */
    public static Map<String, String> environment() {
        return System.getenv();
    }

    /**
     * Reads a file of properties.
     *
     * @param file its name
     * @return value by name; empty if there is no such file
     * @throws IOException if the file cannot be read
     */
    public static Map<String, String> properties(String file) throws IOException {
        Map<String, String> values = new HashMap<>();
        if (Files.isRegularFile(Path.of(file))) {
            try (Reader reader = Files.newBufferedReader(Path.of(file))) {
                Properties properties = new Properties();
                properties.load(reader);
                properties.stringPropertyNames().forEach(name -> values.put(name, properties.getProperty(name)));
            } catch (IllegalArgumentException malformed) {
                throw new IOException(malformed.getMessage(), malformed);
            }
        }
        return values;
    }
}
