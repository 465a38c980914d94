package org.robonewbie.exercises.marking;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.robonewbie.exercises.Exercises;

/**
 * Submissions that a teacher has received as links and files. Damaged submissions, unknown exercises and duplicate
 * names are reported; all other submissions count.
 */
final class ReceivedWork {

    private final Map<String, List<Received>> received = new TreeMap<>();
    private final Map<String, String> troubles = new TreeMap<>();
    private final List<String> senders = new ArrayList<>();

    private record Received(String source, HandIn work) {}

    /** Adds a submission from a source such as {@code anna.robonewbie} or {@code links.txt, line 3}. */
    void add(String source, String json) {
        try {
            HandIn work = HandIn.parse(json);
            List<Received> sameName =
                    received.computeIfAbsent(work.student().toLowerCase(Locale.ROOT), any -> new ArrayList<>());
            if (sameName.stream().noneMatch(other -> other.work().equals(work))) {
                sameName.add(new Received(source, work));
            }
            senders.add(sameName.get(0).work().student());
        } catch (IllegalArgumentException refused) {
            refuse(source, String.valueOf(refused.getMessage()));
        }
    }

    /** Reports a source that could not be read. */
    void refuse(String source, String reason) {
        senders.add("");
        troubles.merge(source, reason, (first, second) -> first.equals(second) ? first : first + " " + second);
    }

    /**
     * Returns the student's name for each submission, in the order in which they were added; empty if the submission
     * could not be read.
     */
    List<String> senders() {
        return List.copyOf(senders);
    }

    /** Returns all students, sorted by name, including those whose submissions do not count. */
    List<String> students() {
        return received.values().stream()
                .map(sameName -> sameName.get(0).work().student())
                .toList();
    }

    /** Returns the accepted submissions, sorted by name. Call this after all submissions have been added. */
    List<HandIn> accepted() {
        return received.values().stream()
                .filter(sameName -> sameName.size() == 1)
                .map(sameName -> sameName.get(0).work())
                .toList();
    }

    /** Returns the reasons why submissions do not count or are incomplete, by student, or by source if the student is unknown. */
    Map<String, String> troubles() {
        Map<String, String> all = new TreeMap<>(troubles);
        for (List<Received> sameName : received.values()) {
            String student = sameName.get(0).work().student();
            problem(sameName)
                    .ifPresent(problem -> all.merge(student, problem, (first, second) -> first + " " + second));
        }
        return all;
    }

    private static Optional<String> problem(List<Received> sameName) {
        if (sameName.size() > 1) {
            return Optional.of("The name occurs " + sameName.size() + " times: "
                    + sameName.stream().map(Received::source).collect(Collectors.joining("; "))
                    + ". None of them was graded; remove all but one.");
        }
        String unknown = sameName.get(0).work().exercises().stream()
                .filter(name -> Exercises.find(name).isEmpty())
                .collect(Collectors.joining(", "));
        return unknown.isEmpty()
                ? Optional.empty()
                : Optional.of("This version has no exercise named " + unknown + ".");
    }
}
