package org.robonewbie.app.marking;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.nao.file.TextFile;

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
     */
    record Pair(String exercise, String first, String second, double likeness, double sameNumbers) {}

    private record Program(String student, SourceShape shape) {}

    /** All pairs, those that are most alike first. */
    static List<Pair> pairs(List<Submission> submissions) {
        List<Pair> pairs = new ArrayList<>();
        submissions.stream()
                .map(Submission::exercise)
                .distinct()
                .forEach(exercise -> pairs.addAll(pairs(
                        exercise,
                        submissions.stream()
                                .filter(each -> each.exercise().equals(exercise))
                                .toList())));
        pairs.sort(Comparator.comparingDouble(Pair::likeness).reversed());
        return pairs;
    }

    private static List<Pair> pairs(Exercise exercise, List<Submission> submissions) {
        SourceShape given = SourceShape.of(exercise.startCode());
        List<Program> programs = submissions.stream()
                .map(each -> new Program(each.student(), SourceShape.of(text(each))))
                .filter(program -> program.shape().ownRuns(given) >= LEAST_OWN_RUNS)
                .toList();
        List<Pair> pairs = new ArrayList<>();
        for (int i = 0; i < programs.size(); i++) {
            for (Program second : programs.subList(i + 1, programs.size())) {
                Program first = programs.get(i);
                double likeness = first.shape().similarityTo(second.shape(), given);
                if (likeness >= ALIKE) {
                    pairs.add(new Pair(
                            exercise.fullName(),
                            first.student(),
                            second.student(),
                            likeness,
                            first.shape().sameNumbers(second.shape())));
                }
            }
        }
        return pairs;
    }

    private static String text(Submission submission) {
        try {
            return TextFile.read(submission.file()).content();
        } catch (IOException unreadable) {
            return "";
        }
    }
}
