package org.robonewbie.exercises.marking;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.stream.Stream;
import org.robonewbie.nao.file.TextFile;
import org.robonewbie.nao.file.UnreadableFileException;
import org.robonewbie.nao.text.ConfusableCharacter;
import org.robonewbie.programs.CalledWronglyException;

/**
 * Mean answers in the evaluation forms of a course, grouped by experience in robotics and in Java. Answers are numbers from 1
 * to 5.
 */
public final class EvaluationSummary {

    private static final List<String> EXPERIENCES = List.of("robotics", "java");
    private static final String PROPORTION = "proportion";
    private static final String SEPARATOR = "[,;\t]";

    private final List<String> questions;
    private final List<double[]> answers;

    private EvaluationSummary(List<String> questions, List<double[]> answers) {
        this.questions = questions;
        this.answers = answers;
    }

    /** Participants whose experience is within a range. */
    private record Group(String name, String experience, double least, double most) {}

    /**
     * Reads the answers.
     *
     * @param file a file with one line of answers per participant
     * @return the means
     * @throws CalledWronglyException if the file cannot be read or parsed; the message contains the file name and the
     *     line number
     */
    public static EvaluationSummary of(Path file) {
        try {
            return of(TextFile.readAndNote(file).lines());
        } catch (UnreadableFileException unreadable) {
            throw new CalledWronglyException(String.valueOf(unreadable.getMessage()));
        } catch (CalledWronglyException wrong) {
            throw new CalledWronglyException(file + ": " + wrong.getMessage());
        }
    }

    static EvaluationSummary of(List<String> lines) {
        if (lines.isEmpty()) {
            throw new CalledWronglyException(
                    "The file is empty. Its first line must contain the names of the questions.");
        }
        ConfusableCharacter.firstIn(lines.get(0)).ifPresent(character -> {
            throw new CalledWronglyException("Line 1: in \"" + lines.get(0) + "\", " + character + ".");
        });
        List<String> questions = cells(lines.get(0).toLowerCase(Locale.ROOT));
        if (questions.stream().distinct().count() < questions.size()) {
            throw new CalledWronglyException("Line 1: two questions have the same name. Rename one of them.");
        }
        List<double[]> answers = new ArrayList<>();
        for (int i = 1; i < lines.size(); i++) {
            if (!lines.get(i).isBlank()) {
                answers.add(answer(lines.get(i), i + 1, questions.size()));
            }
        }
        return new EvaluationSummary(questions, answers);
    }

    @Override
    public String toString() {
        List<Group> groups = new ArrayList<>(List.of(new Group("all", "", 0, 5)));
        for (String experience : EXPERIENCES) {
            if (questions.contains(experience)) {
                groups.add(new Group(experience + " little", experience, 1, 2));
                groups.add(new Group(experience + " some", experience, 3, 3));
                groups.add(new Group(experience + " much", experience, 4, 5));
            }
        }
        StringBuilder table = new StringBuilder(String.format("%-16s%8s", "experience", "people"));
        questions.forEach(question -> table.append(String.format("  %11.11s", question)));
        table.append(System.lineSeparator());
        groups.forEach(group -> append(table, group));
        for (String experience : EXPERIENCES) {
            if (!questions.contains(experience)) {
                table.append("There is no column \"" + experience + "\", so the answers are not grouped by it.")
                        .append(System.lineSeparator());
            }
        }
        if (questions.contains(PROPORTION)) {
            table.append(PROPORTION
                            + ": 1 = much more lecture, 3 = the proportion of the course, 5 = much more exercise")
                    .append(System.lineSeparator());
        }
        return table.toString();
    }

    private void append(StringBuilder table, Group group) {
        List<double[]> members =
                answers.stream().filter(answer -> belongs(answer, group)).toList();
        table.append(String.format("%-16s%8d", group.name, members.size()));
        for (int i = 0; i < questions.size(); i++) {
            int column = i;
            OptionalDouble mean =
                    members.stream().mapToDouble(answer -> answer[column]).average();
            table.append(
                    mean.isPresent() ? String.format(Locale.ROOT, "  %11.2f", mean.getAsDouble()) : "            -");
        }
        table.append(System.lineSeparator());
    }

    private boolean belongs(double[] answer, Group group) {
        if (group.experience.isEmpty()) {
            return true;
        }
        double experience = answer[questions.indexOf(group.experience)];
        return experience >= group.least && experience <= group.most;
    }

    private static double[] answer(String line, int number, int questions) {
        List<String> words = cells(line);
        if (words.size() != questions) {
            throw new CalledWronglyException(
                    "Line " + number + " has " + words.size() + " answers, but there are " + questions + " questions.");
        }
        double[] answers = new double[questions];
        for (int i = 0; i < questions; i++) {
            answers[i] = number(words.get(i), number);
        }
        return answers;
    }

    /** Splits a line into cells and removes the quotation marks that spreadsheets add. */
    private static List<String> cells(String line) {
        return Stream.of(line.strip().split(SEPARATOR, -1))
                .map(cell -> cell.strip().replaceFirst("^\"(.*)\"$", "$1").strip())
                .toList();
    }

    private static double number(String word, int line) {
        if (!word.matches("[1-5]")) {
            throw new CalledWronglyException(
                    "Line " + line + ": \"" + word + "\" is not an answer. Answers are numbers from 1 to 5.");
        }
        return Double.parseDouble(word);
    }
}
