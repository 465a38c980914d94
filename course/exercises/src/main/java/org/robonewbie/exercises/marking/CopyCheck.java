package org.robonewbie.exercises.marking;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HexFormat;
import java.util.List;
import java.util.Optional;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.nao.file.RegularFile;
import org.robonewbie.nao.file.TextFile;
import org.robonewbie.nao.file.UnreadableFileException;

/**
 * Plagiarism check: finds programs that are too similar to have been written independently. The starter code of the exercise is
 * ignored.
 */
final class CopyCheck {

    /** Minimum number of original n-grams for a comparison, because shorter programs may be similar by chance. */
    private static final int MIN_OWN_RUNS = 40;

    private static final double MIN_LIKENESS = 0.8;

    private CopyCheck() {}

    /**
     * Two similar programs.
     *
     * @param exercise full name of the exercise
     * @param first a student
     * @param second another student
     * @param likeness share of the shorter program that also occurs in the longer one, 0 to 1
     * @param sameNumbers share of numeric literals that occur in both programs, 0 to 1
     * @param identical whether the two files have the same text
     */
    record Pair(String exercise, String first, String second, double likeness, double sameNumbers, boolean identical) {}

    /**
     * Statistics of the programs of one exercise.
     *
     * @param exercise name of the exercise
     * @param programs the number of programs
     * @param comparable the number of programs with enough original code to be compared
     * @param unchanged the number of programs that are identical to the starter code
     */
    record Comparison(String exercise, int programs, int comparable, int unchanged) {

        private boolean isComplete() {
            return programs < 2 || comparable == programs;
        }
    }

    /**
     * Result of the check.
     *
     * @param pairs similar programs, the most similar ones first
     * @param comparisons statistics by exercise
     */
    record Result(List<Pair> pairs, List<Comparison> comparisons) {

        /** {@return statistics of the exercises in which some programs could not be compared} */
        List<Comparison> incomplete() {
            return comparisons.stream().filter(each -> !each.isComplete()).toList();
        }
    }

    /**
     * A program to compare.
     *
     * @param student name of the student
     * @param exercise the exercise
     * @param text source of the program
     */
    record Program(String student, Exercise exercise, String text) {}

    private record Shaped(String student, String text, SourceShape shape) {}

    /** Reads the programs, and compares each with the other programs for the same exercise. */
    static Result of(List<Submission> submissions) {
        return ofPrograms(submissions.stream()
                .map(each -> new Program(each.student(), each.exercise(), text(each)))
                .toList());
    }

    /** Compares each program with the other programs for the same exercise. */
    static Result ofPrograms(List<Program> programs) {
        List<Pair> pairs = new ArrayList<>();
        List<Comparison> comparisons = new ArrayList<>();
        programs.stream()
                .map(Program::exercise)
                .distinct()
                .forEach(exercise -> comparisons.add(compare(
                        exercise,
                        programs.stream()
                                .filter(each -> each.exercise().equals(exercise))
                                .toList(),
                        pairs)));
        pairs.sort(Comparator.comparing(Pair::identical)
                .thenComparing(Pair::likeness)
                .reversed());
        return new Result(pairs, comparisons);
    }

    private static Comparison compare(Exercise exercise, List<Program> submitted, List<Pair> pairs) {
        SourceShape given = SourceShape.of(exercise.startCode());
        String start = plain(exercise.startCode());
        List<Shaped> programs = submitted.stream()
                .map(each -> new Shaped(each.student(), plain(each.text()), SourceShape.of(each.text())))
                .toList();
        List<Shaped> changed =
                programs.stream().filter(each -> !each.text().equals(start)).toList();
        for (int i = 0; i < changed.size(); i++) {
            for (Shaped second : changed.subList(i + 1, changed.size())) {
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

    private static Optional<Pair> compare(Exercise exercise, SourceShape given, Shaped first, Shaped second) {
        boolean identical = first.text().equals(second.text());
        boolean comparable = isComparable(first, given) && isComparable(second, given);
        double likeness = identical ? 1 : comparable ? first.shape().similarityTo(second.shape(), given) : 0;
        return likeness < MIN_LIKENESS
                ? Optional.empty()
                : Optional.of(new Pair(
                        exercise.fullName(),
                        first.student(),
                        second.student(),
                        likeness,
                        first.shape().sameNumbers(second.shape()),
                        identical));
    }

    private static boolean isComparable(Shaped program, SourceShape given) {
        return program.shape().ownRuns(given) >= MIN_OWN_RUNS;
    }

    /** Normalises details that editors may change: line endings, byte order mark and trailing whitespace. */
    private static String plain(String text) {
        return text.replace("\uFEFF", "")
                .replace("\r\n", "\n")
                .replace('\r', '\n')
                .replaceAll("[^\\S\\n]+\\n", "\n")
                .strip();
    }

    /** Returns a program's text, or its bytes in hexadecimal if it is not text. */
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
