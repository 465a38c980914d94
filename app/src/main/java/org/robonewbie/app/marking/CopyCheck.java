package org.robonewbie.app.marking;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HexFormat;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.nao.file.RegularFile;
import org.robonewbie.nao.file.TextFile;
import org.robonewbie.nao.file.UnreadableFileException;

/** Finds programs of a class that are too much alike to be the work of two people. The program to begin with does not count. */
final class CopyCheck {

    /** Programs with less of their own than this are alike by themselves. */
    private static final int LEAST_OWN_RUNS = 40;

    private static final double ALIKE = 0.8;

    private CopyCheck() {}

    /**
     * Two programs that are alike.
     *
     * @param exercise full name of the exercise
     * @param first a student
     * @param second another one
     * @param likeness share of the shorter program that is in the other one, 0 to 1
     * @param sameNumbers share of the numbers that are the same, 0 to 1
     * @param identical whether the two files are the same, letter by letter
     */
    record Pair(String exercise, String first, String second, double likeness, double sameNumbers, boolean identical) {}

    /**
     * What the programs of one exercise show.
     *
     * @param exercise its name
     * @param programs how many programs there are
     * @param comparable how many of them hold enough of their authors' own to be compared
     * @param unchanged how many of them are the program to begin with
     */
    record Comparison(String exercise, int programs, int comparable, int unchanged) {

        private boolean isComplete() {
            return programs < 2 || comparable == programs;
        }
    }

    /**
     * What was found.
     *
     * @param pairs programs that are alike, those that are most alike first
     * @param comparisons what was compared, by exercise
     */
    record Result(List<Pair> pairs, List<Comparison> comparisons) {

        /** {@return exercises with programs that could not be compared; empty if all could} */
        List<Comparison> incomplete() {
            return comparisons.stream().filter(each -> !each.isComplete()).toList();
        }
    }

    private record Program(String student, String text, SourceShape shape) {}

    /** Compares all programs with those of the same exercise. */
    static Result of(List<Submission> submissions) {
        List<Pair> pairs = new ArrayList<>();
        List<Comparison> comparisons = new ArrayList<>();
        submissions.stream()
                .map(Submission::exercise)
                .distinct()
                .forEach(exercise -> comparisons.add(compare(
                        exercise,
                        submissions.stream()
                                .filter(each -> each.exercise().equals(exercise))
                                .toList(),
                        pairs)));
        pairs.sort(Comparator.comparing(Pair::identical)
                .thenComparing(Pair::likeness)
                .reversed());
        return new Result(pairs, comparisons);
    }

    private static Comparison compare(Exercise exercise, List<Submission> submissions, List<Pair> pairs) {
        SourceShape given = SourceShape.of(exercise.startCode());
        String start = plain(exercise.startCode());
        List<Program> programs = submissions.stream()
                .map(each -> new Program(each.student(), plain(text(each)), SourceShape.of(text(each))))
                .toList();
        List<Program> changed =
                programs.stream().filter(each -> !each.text().equals(start)).toList();
        for (int i = 0; i < changed.size(); i++) {
            for (Program second : changed.subList(i + 1, changed.size())) {
                compare(exercise, given, changed.get(i), second).ifPresent(pairs::add);
            }
        }
        return new Comparison(
                exercise.name(),
                programs.size(),
                (int) programs.stream()
                        .filter(each -> isComparable(each, given))
                        .count(),
                programs.size() - changed.size());
    }

    private static Optional<Pair> compare(Exercise exercise, SourceShape given, Program first, Program second) {
        boolean identical = first.text().equals(second.text());
        boolean comparable = isComparable(first, given) && isComparable(second, given);
        double likeness = identical ? 1 : comparable ? first.shape().similarityTo(second.shape(), given) : 0;
        return likeness < ALIKE
                ? Optional.empty()
                : Optional.of(new Pair(
                        exercise.fullName(),
                        first.student(),
                        second.student(),
                        likeness,
                        first.shape().sameNumbers(second.shape()),
                        identical));
    }

    private static boolean isComparable(Program program, SourceShape given) {
        return program.shape().ownRuns(given) >= LEAST_OWN_RUNS;
    }

    /** The text without what editors change by themselves: line ends, a byte order mark, blanks at the ends of lines. */
    private static String plain(String text) {
        return text.replace("\uFEFF", "")
                .lines()
                .map(String::stripTrailing)
                .collect(Collectors.joining("\n"))
                .strip();
    }

    /** The text of a program; of a file that is no text its bytes in hexadecimal, which only a copy of it has too. */
    private static String text(Submission submission) {
        try {
            return TextFile.read(submission.file()).content();
        } catch (UnreadableFileException noText) {
            return bytes(submission.file());
        }
    }

    private static String bytes(Path file) {
        try {
            return HexFormat.of().formatHex(RegularFile.read(file, TextFile.MAX_BYTES));
        } catch (UnreadableFileException unreadable) {
            return file.toString();
        }
    }
}
