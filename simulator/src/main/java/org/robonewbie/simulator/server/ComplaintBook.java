package org.robonewbie.simulator.server;

import java.util.HashSet;
import java.util.Set;

/** Names the problems of one connection, each kind once, so that a noisy client cannot flood the console. */
final class ComplaintBook {

    private static final int LIMIT = 20;

    private final Console console;
    private final String subject;
    private final Set<String> known = new HashSet<>();

    ComplaintBook(Console console, String subject) {
        this.console = console;
        this.subject = subject;
    }

    /**
     * Names a problem unless this kind of problem was named before.
     *
     * @param kind what tells this problem from others
     * @param sentence what happened, with value and advice; begins with a verb, since the connection is its subject
     */
    void complain(String kind, String sentence) {
        if (known.size() < LIMIT && known.add(kind)) {
            console.say(subject + " " + sentence);
            if (known.size() == LIMIT) {
                console.say(subject + " made " + LIMIT + " kinds of mistakes; more of its mistakes are not told.");
            }
        }
    }
}
