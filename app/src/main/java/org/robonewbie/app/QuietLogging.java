package org.robonewbie.app;

import java.util.logging.ConsoleHandler;
import java.util.logging.Level;
import java.util.logging.Logger;

/**
 * Keeps the console for what people need: libraries report warnings and errors only, each in one line. {@link
 * java.util.logging.LogManager} makes an instance of this class when the first logger is asked for.
 */
public final class QuietLogging {

    private static final String LINE = "%4$s: %5$s (%3$s)%n";

    /** Sets up the root logger. */
    public QuietLogging() {
        Logger root = Logger.getLogger("");
        root.setLevel(Level.WARNING);
        root.addHandler(new ConsoleHandler());
    }

    /** Installs this as the configuration of all loggers, unless the user has configured another one. */
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
