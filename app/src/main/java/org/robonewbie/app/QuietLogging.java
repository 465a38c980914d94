package org.robonewbie.app;

import java.util.logging.ConsoleHandler;
import java.util.logging.Level;
import java.util.logging.Logger;

/**
 * Logging configuration that prints only the warnings and errors of libraries, each on one line. {@link
 * java.util.logging.LogManager} instantiates it when the first logger is created.
 */
public final class QuietLogging {

    private static final String LINE = "%4$s: %5$s (%3$s)%n";

    /** Configures the root logger. */
    public QuietLogging() {
        Logger root = Logger.getLogger("");
        root.setLevel(Level.WARNING);
        root.addHandler(new ConsoleHandler());
    }

    /** Installs this configuration unless the user specified another one. */
    static void install() {
        setIfAbsent("java.util.logging.config.class", QuietLogging.class.getName());
        setIfAbsent("java.util.logging.SimpleFormatter.format", LINE);
    }

    private static void setIfAbsent(String property, String value) {
        if (System.getProperty("java.util.logging.config.file") == null && System.getProperty(property) == null) {
            System.setProperty(property, value);
        }
    }
}
