package org.robonewbie.simulator.cycle;

import java.util.HashSet;
import java.util.Set;
import org.robonewbie.simulator.Console;

/**
 * A logger for problems with one connection. Each kind of problem is logged only once, so that a faulty client cannot
 * flood the console.
 */
public final class RateLimitedLogger {

    private static final int LIMIT = 20;

    private final Console console;
    private final String subject;
    private final Set<String> known = new HashSet<>();

    /**
     * Creates a logger.
     *
     * @param console the output
     * @param subject grammatical subject of the messages, such as {@code The agent at 127.0.0.1:4711}
     */
    public RateLimitedLogger(Console console, String subject) {
        this.console = console;
        this.subject = subject;
    }

    /**
     * Logs a problem unless one of the same kind has been logged before.
     *
     * @param kind key that identifies the kind of problem
     * @param sentence the message without its subject
     */
    public void warn(String kind, String sentence) {
        if (known.size() < LIMIT && known.add(kind)) {
            console.say(subject + " " + sentence);
            if (known.size() == LIMIT) {
                console.say(subject + " caused " + LIMIT + " kinds of warnings; further ones are suppressed.");
            }
        }
    }
}
