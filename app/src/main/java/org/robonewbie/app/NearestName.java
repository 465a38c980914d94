package org.robonewbie.app;

import java.util.Collection;
import java.util.Comparator;
import java.util.Locale;
import java.util.Optional;

/**
 * Finds what somebody may have meant: a name that contains what was written, else the one that needs the fewest changed
 * letters (Levenshtein, 1965).
 */
final class NearestName {

    private static final int SHORTEST_PART = 3;

    private NearestName() {}

    /** Finds the nearest of some names, or nothing if all are too different. */
    static Optional<String> of(String written, Collection<String> names) {
        return containing(written, names).or(() -> similar(written, names));
    }

    private static Optional<String> containing(String written, Collection<String> names) {
        String part = written.toLowerCase(Locale.ROOT);
        return names.stream()
                .filter(name -> part.length() >= SHORTEST_PART
                        && name.toLowerCase(Locale.ROOT).contains(part))
                .min(Comparator.comparingInt(String::length));
    }

    private static Optional<String> similar(String written, Collection<String> names) {
        return names.stream()
                .min(Comparator.comparingInt(name -> distance(written, name)))
                .filter(name -> distance(written, name) <= Math.max(2, name.length() / 2));
    }

    private static int distance(String written, String name) {
        String a = written.toLowerCase(Locale.ROOT);
        String b = name.toLowerCase(Locale.ROOT);
        int[] previous = new int[b.length() + 1];
        for (int j = 0; j <= b.length(); j++) {
            previous[j] = j;
        }
        for (int i = 1; i <= a.length(); i++) {
            int[] current = new int[b.length() + 1];
            current[0] = i;
            for (int j = 1; j <= b.length(); j++) {
                int changed = previous[j - 1] + (a.charAt(i - 1) == b.charAt(j - 1) ? 0 : 1);
                current[j] = Math.min(changed, 1 + Math.min(previous[j], current[j - 1]));
            }
            previous = current;
        }
        return previous[b.length()];
    }
}
