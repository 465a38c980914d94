package org.robonewbie.competition.contest;

import java.util.Locale;

/** Role of a program in a trial. A team may provide a separate program for each role. */
public enum Role {
    /** The only role in a contest without special roles. */
    MAIN,
    /** Attacker in a penalty shoot-out. */
    ATTACKER,
    /** Goalkeeper in a penalty shoot-out. */
    GOALKEEPER;

    /** {@return the name of the role in a team list, such as {@code attacker}} */
    public String key() {
        return name().toLowerCase(Locale.ROOT);
    }
}
