package org.robonewbie.exercises.marking;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Score;
import org.robonewbie.nao.file.AtomicFile;
import org.robonewbie.nao.text.Csv;
import org.robonewbie.nao.text.Html;

/**
 * Table of grades, with a row for each student and a column for each exercise.
 *
 * @param exercises the columns
 * @param students the rows
 * @param marks the grades
 * @param troubles reasons why submissions could not be graded, by student, or by source for sources that could not be
 *     read
 * @param copies result of the plagiarism check
 * @param seeds the number of trials for each program
 */
record ClassTable(
        List<Exercise> exercises,
        List<String> students,
        List<Mark> marks,
        Map<String, String> troubles,
        CopyCheck.Result copies,
        int seeds) {

    private static final String STYLE = """
        :root { color-scheme: light dark; }
        body { font: 1rem/1.45 system-ui, sans-serif; margin: 2rem; }
        h1 { font-size: 1.6rem; margin-bottom: 0.2rem; }
        .wide { overflow-x: auto; }
        table { border-collapse: collapse; margin: 1rem 0 2rem; }
        th, td { padding: 0.3rem 0.5rem; border: 1px solid #8886; text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
        th:first-child, td:first-child, table.words td { text-align: left; }
        table.words td { white-space: normal; }
        thead th { vertical-align: bottom; }
        .wide :is(th, td):first-child { position: sticky; left: 0; background: Canvas; }
        .exercise { font-weight: normal; writing-mode: vertical-rl; transform: rotate(180deg); text-align: left; margin-left: auto; }
        .passed { background: #2a83; }
        .begun { background: #c904; }
        .broken { background: #d335; }
        .note { opacity: 0.75; max-width: 50rem; }
        @media print { body { margin: 0; } }
        """;

    private static final String PAGE = "grades.html";

    private static final String IDENTICAL = "identical files";

    /** Writes all files into a folder and returns the HTML page. */
    Path write(Path folder) throws IOException {
        for (Map.Entry<String, String> file : files().entrySet()) {
            AtomicFile.write(folder.resolve(file.getKey()), file.getValue());
        }
        return folder.resolve(PAGE);
    }

    /** Returns the contents of all files by name. */
    Map<String, String> files() {
        return Map.of("grades.csv", csv(), "findings.csv", findings(), "copies.csv", copiesCsv(), PAGE, html());
    }

    /** Returns a summary of the plagiarism check, as sentences. */
    String sentence() {
        List<CopyCheck.Pair> pairs = copies.pairs();
        int comparable = copies.comparisons().stream()
                .filter(each -> each.comparable() > 1)
                .mapToInt(CopyCheck.Comparison::comparable)
                .sum();
        String alike = switch (pairs.size()) {
            case 0 ->
                comparable == 0
                        ? "No programs could be compared with each other."
                        : "None of the " + comparable + " compared programs are alike.";
            case 1 ->
                "One pair of programs is alike: " + pairs.get(0).first() + " and "
                        + pairs.get(0).second() + ", " + pairs.get(0).exercise() + ".";
            default -> pairs.size() + " pairs of programs are alike: see copies.csv.";
        };
        return Stream.of(alike, notCompared(), unchanged())
                .filter(part -> !part.isEmpty())
                .collect(Collectors.joining(" "));
    }

    private String notCompared() {
        List<CopyCheck.Comparison> exercises = copies.incomplete();
        String names = exercises.stream()
                .map(each -> each.exercise() + ": "
                        + (each.comparable() == 0
                                ? "none of " + each.programs()
                                : each.comparable() + " of " + each.programs() + " compared"))
                .collect(Collectors.joining(", "));
        return switch (exercises.size()) {
            case 0 -> "";
            case 1 -> "1 exercise has too little original code to compare (" + names + ").";
            default -> exercises.size() + " exercises have too little original code to compare (" + names + ").";
        };
    }

    private String unchanged() {
        String names = copies.comparisons().stream()
                .filter(each -> each.unchanged() > 0)
                .map(each -> each.exercise() + ": " + each.unchanged())
                .collect(Collectors.joining(", "));
        return names.isEmpty() ? "" : "The starter code was submitted unchanged (" + names + ").";
    }

    private String csv() {
        Stream<String> head = Stream.of(
                        Stream.of("student"),
                        exercises.stream().map(Exercise::fullName),
                        Stream.of("points", "passed", "note"))
                .flatMap(words -> words);
        List<String> lines = new ArrayList<>(List.of(Csv.line(head)));
        for (String student : Stream.concat(students.stream(), unreadable()).toList()) {
            Stream<String> cells = exercises.stream()
                    .map(exercise ->
                            mark(student, exercise).map(ClassTable::points).orElse(""));
            lines.add(Csv.line(
                    Stream.of(Stream.of(student), cells, Stream.of(sum(student), passed(student), note(student)))
                            .flatMap(words -> words)));
        }
        return Csv.text(lines);
    }

    private String findings() {
        List<String> lines =
                new ArrayList<>(List.of(Csv.line(Stream.of("student", "exercise", "points", "passed", "finding"))));
        for (Mark mark : marks) {
            lines.add(Csv.line(Stream.of(
                    mark.student(), mark.exercise(), points(mark), mark.passed() ? "yes" : "no", mark.finding())));
        }
        return Csv.text(lines);
    }

    private String copiesCsv() {
        List<String> lines = new ArrayList<>(List.of(
                Csv.line(Stream.of("exercise", "student", "other", "alike percent", "same numbers percent", "note"))));
        for (CopyCheck.Pair pair : copies.pairs()) {
            lines.add(Csv.line(Stream.of(
                    pair.exercise(),
                    pair.first(),
                    pair.second(),
                    percent(pair.likeness()),
                    percent(pair.sameNumbers()),
                    pair.identical() ? IDENTICAL : "")));
        }
        for (CopyCheck.Comparison each : copies.incomplete()) {
            lines.add(Csv.line(Stream.of(
                    each.exercise(),
                    "",
                    "",
                    "",
                    "",
                    each.comparable() + " of " + each.programs() + " programs have enough original code to compare")));
        }
        return Csv.text(lines);
    }

    private String html() {
        String heads = exercises.stream()
                .map(exercise -> "<th title=\"" + Html.text(exercise.title()) + "\"><div class=\"exercise\">"
                        + exercise.number() + " " + Html.text(exercise.name()) + "</div></th>")
                .collect(Collectors.joining());
        String rows = students.stream().map(this::row).collect(Collectors.joining());
        return Html.page("Grades", STYLE, """
            <h1>Grades</h1>
            <p class="note">Points are means over %d trials. Green: all trials passed; yellow: some failed; red: the program could not be
            started; empty: not graded. Hover over a cell to see what was measured.</p>
            <div class="wide"><table>
            <thead><tr><th>Student</th><th>Points</th><th>Passed</th>%s</tr></thead>
            <tbody>
            %s</tbody></table></div>
            %s%s%s""".formatted(
                        seeds,
                        heads,
                        rows,
                        notes("What could not be graded", students.stream()),
                        notes("Links and files that could not be read", unreadable()),
                        alike()));
    }

    private String row(String student) {
        String cells = exercises.stream()
                .map(exercise -> mark(student, exercise).map(ClassTable::cell).orElse("<td></td>"))
                .collect(Collectors.joining());
        String sums = isGraded(student)
                ? "<td>" + sum(student) + "</td><td>" + passed(student) + "</td>"
                : "<td colspan=\"2\" title=\"" + Html.text(note(student)) + "\">not graded</td>";
        return "<tr><td>" + Html.text(student) + "</td>" + sums + cells + "</tr>\n";
    }

    private static String cell(Mark mark) {
        String kind = mark.passed() ? "passed" : mark.grade().isPresent() ? "begun" : "broken";
        return "<td class=\"" + kind + "\" title=\"" + Html.text(mark.finding()) + "\">" + points(mark)
                + (mark.passed() ? " ✓" : "") + "</td>";
    }

    /** Returns the sources of submissions that could not be read. */
    private Stream<String> unreadable() {
        return troubles.keySet().stream()
                .filter(source -> !students.contains(source))
                .sorted();
    }

    private String notes(String title, Stream<String> names) {
        String rows = names.filter(student -> !note(student).isEmpty())
                .map(student ->
                        "<tr><td>" + Html.text(student) + "</td><td>" + Html.text(note(student)) + "</td></tr>\n")
                .collect(Collectors.joining());
        return rows.isEmpty() ? "" : "<h2>" + title + "</h2>\n<table class=\"words\">" + rows + "</table>\n";
    }

    private String alike() {
        String rows = copies.pairs().stream()
                .map(pair -> "<tr><td>" + pair.exercise() + "</td><td>" + Html.text(pair.first()) + "</td><td>"
                        + Html.text(pair.second()) + "</td><td>" + percent(pair.likeness()) + " %</td><td>"
                        + percent(pair.sameNumbers()) + " %</td><td>" + (pair.identical() ? IDENTICAL : "")
                        + "</td></tr>\n")
                .collect(Collectors.joining());
        String table = rows.isEmpty() ? "" : """
                <table class="words"><tr><th>Exercise</th><th>Student</th><th>Other</th><th>Alike</th><th>Same numbers</th><th>Note</th></tr>
                %s</table>
                """.formatted(rows);
        return """
                <h2>Programs that are alike</h2>
                <p>%s</p>
                <p class="note">Comments, layout, identifiers, numbers and the starter code are ignored. Ask both authors to explain
                their program before you judge.</p>
                %s""".formatted(Html.text(sentence()), table);
    }

    /** Returns why some of a student's programs could not be graded. */
    private String note(String student) {
        Stream<String> broken = marks(student)
                .filter(mark -> mark.grade().isEmpty())
                .map(mark -> mark.exercise() + ": " + mark.reason());
        return Stream.concat(Optional.ofNullable(troubles.get(student)).stream(), broken)
                .collect(Collectors.joining(" "));
    }

    private Optional<Mark> mark(String student, Exercise exercise) {
        return marks(student)
                .filter(mark -> mark.exercise().equals(exercise.name()))
                .findFirst();
    }

    private Stream<Mark> marks(String student) {
        return marks.stream().filter(mark -> mark.student().equals(student));
    }

    private boolean isGraded(String student) {
        return marks(student).findAny().isPresent();
    }

    private String sum(String student) {
        return isGraded(student)
                ? number(marks(student).mapToDouble(Mark::points).sum())
                : "";
    }

    private String passed(String student) {
        return isGraded(student)
                ? String.valueOf(marks(student).filter(Mark::passed).count())
                : "";
    }

    private static String points(Mark mark) {
        return number(Math.min(Score.MAX_POINTS, mark.points()));
    }

    private static String number(double value) {
        return String.format(Locale.ROOT, "%.1f", value);
    }

    private static String percent(double share) {
        return String.valueOf(Math.round(100 * share));
    }
}
