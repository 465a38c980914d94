package org.robonewbie.competition.contest;

import java.util.Locale;

/** The role of a program in a trial. A team may have a program of its own for each role. */
public enum Role {
    /** Whatever the contest asks for. */
    MAIN,
    /** Shoots penalties. */
    ATTACKER,
    /** Keeps the goal against penalties. */
    GOALKEEPER;

    /** {@return the word for it in a file of teams, such as {@code attacker}} */
    public String key() {
        return name().toLowerCase(Locale.ROOT);
    }
}
