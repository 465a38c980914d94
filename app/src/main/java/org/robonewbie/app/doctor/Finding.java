package org.robonewbie.app.doctor;

import java.util.Locale;

/**
 * What one check of the installation has found.
 *
 * @param subject what was checked, one or two words
 * @param verdict whether it is well
 * @param found what was found
 * @param advice what to do; empty if nothing
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

    /**
     * Writes the finding for people.
     *
     * @return one line, and a second one with the advice if there is one
     */
    public String toText() {
        String line = String.format(Locale.ROOT, "%-5s %-14s %s", verdict.mark(), subject, found);
        return advice.isEmpty() ? line : line + System.lineSeparator() + " ".repeat(21) + "-> " + advice;
    }
}
