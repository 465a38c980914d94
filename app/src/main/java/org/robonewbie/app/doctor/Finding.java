package org.robonewbie.app.doctor;

import java.util.Locale;

/**
 * Result of one check of the installation.
 *
 * @param subject what was checked, in one or two words
 * @param verdict severity
 * @param found the observation
 * @param advice what to do; may be empty
 */
public record Finding(String subject, Verdict verdict, String found, String advice) {

    static Finding well(String subject, String found) {
        return new Finding(subject, Verdict.WELL, found, "");
    }

    static Finding notable(String subject, String found, String advice) {
        return new Finding(subject, Verdict.NOTABLE, found, advice);
    }

    static Finding broken(String subject, String found, String advice) {
        return new Finding(subject, Verdict.BROKEN, found, advice);
    }

    /** {@return the finding as one line, followed by a line with the advice, if any} */
    public String toText() {
        String line = String.format(Locale.ROOT, "%-5s %-14s %s", verdict.mark(), subject, found);
        return advice.isEmpty() ? line : line + System.lineSeparator() + " ".repeat(21) + "-> " + advice;
    }
}
