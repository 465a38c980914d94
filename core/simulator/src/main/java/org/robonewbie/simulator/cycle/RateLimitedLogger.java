package org.robonewbie.simulator.cycle;

import java.util.HashSet;
import java.util.Set;
import org.robonewbie.simulator.Console;

/** Reports the problems of one connection, each kind once, so that a noisy client cannot flood the console. */
public final class RateLimitedLogger {

    private static final int LIMIT = 20;

    private final Console console;
    private final String subject;
    private final Set<String> known = new HashSet<>();

    /**
     * Creates an empty log.
     *
     * @param console where to tell the problems
     * @param subject of the sentences, such as {@code The agent at 127.0.0.1:4711}
     */
    public RateLimitedLogger(Console console, String subject) {
        this.console = console;
        this.subject = subject;
    }

    /**
     * Reports a problem unless this kind of problem was reported before.
     *
     * @param kind distinguishes this problem from others
     * @param sentence what happened, with value and advice; begins with a verb, since the connection is its subject
     */
    public void warn(String kind, String sentence) {
        if (known.size() < LIMIT && known.add(kind)) {
            console.say(subject + " " + sentence);
            if (known.size() == LIMIT) {
                console.say(subject + " made " + LIMIT + " kinds of mistakes; more of its mistakes are not told.");
            }
        }
    }
}
