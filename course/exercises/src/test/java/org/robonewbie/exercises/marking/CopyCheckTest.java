package org.robonewbie.exercises.marking;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Exercises;

class CopyCheckTest {

    private static final String OWN = """
            @Override
            protected void think() {
                double error = %s - nao.getJointAngle(Joint.LEFT_SHOULDER_PITCH);
                double speed = Math.max(-100, Math.min(100, 4 * error));
                if (Math.abs(error) < 0.2) { speed = 0; log.info("there"); }
                nao.setJointSpeed(Joint.LEFT_SHOULDER_PITCH, speed);
                if (nao.getTime() > 3 && motions.isFinished()) { motions.start("wave"); }
            }
            """;
    private static final String OTHER = """
            private int cycles;
            @Override
            protected void think() {
                cycles++;
                for (Joint joint : Joint.values()) { if (joint.name().startsWith("LEFT")) { turn(joint); } }
                while (cycles > 100) { cycles -= 100; }
            }
            private void turn(Joint joint) { nao.setJointAngle(joint, cycles %% 7 == 0 ? 3 : joint.maxDegrees() / 2, 20); }
            """;

    @TempDir
    private Path folder;

    private final List<Submission> submissions = new ArrayList<>();

    @Test
    void identicalFilesAreNamedHoweverLittleTheyHold() throws IOException {
        handIn("anna", "stop-at-30", start("stop-at-30").replace("}", "// 30\n}"));
        handIn(
                "ben",
                "stop-at-30",
                "\uFEFF" + start("stop-at-30").replace("}", "// 30\n}").replace("\n", " \r\n"));

        CopyCheck.Result result = CopyCheck.of(submissions);

        assertThat(result.pairs())
                .singleElement()
                .matches(CopyCheck.Pair::identical)
                .matches(pair -> pair.first().equals("anna") && pair.second().equals("ben"));
        assertThat(sentence(result))
                .isEqualTo(
                        "One pair of programs is alike: anna and ben, 02-stop-at-30. 1 exercise has too little original code"
                                + " to compare (stop-at-30: none of 2).");
    }

    @Test
    void neverSaysThatThereAreNoCopiesWhereNothingWasCompared() throws IOException {
        handIn("anna", "stop-at-30", start("stop-at-30").replace("}", "// 30\n}"));
        handIn("ben", "stop-at-30", start("stop-at-30").replace("}", "// 31\n}"));

        assertThat(sentence(CopyCheck.of(submissions)))
                .isEqualTo("No programs could be compared with each other. 1 exercise has too little original code"
                        + " to compare (stop-at-30: none of 2).");
    }

    @Test
    void countsTheProgramsThatWereCompared() throws IOException {
        handIn("anna", "arm-by-side", OWN.formatted("30"));
        handIn("ben", "arm-by-side", OTHER.formatted());
        handIn("cora", "arm-by-side", start("arm-by-side").replace("}", "// ?\n}"));
        handIn("dora", "raise-arms", OWN.formatted("30"));

        assertThat(sentence(CopyCheck.of(submissions)))
                .isEqualTo("None of the 2 compared programs are alike. 1 exercise has too little original code"
                        + " to compare (arm-by-side: 2 of 3 compared).");
    }

    @Test
    void theProgramToBeginWithIsNoCopyButSaid() throws IOException {
        for (String student : List.of("anna", "ben", "cora")) {
            handIn(student, "arm-by-side", start("arm-by-side"));
        }

        CopyCheck.Result result = CopyCheck.of(submissions);

        assertThat(result.pairs()).isEmpty();
        assertThat(sentence(result)).endsWith("The starter code was submitted unchanged (arm-by-side: 3).");
    }

    @Test
    void tableAndPageSayTheSame() throws IOException {
        handIn("anna", "arm-by-side", OWN.formatted("30"));
        handIn("ben", "arm-by-side", OWN.formatted("30"));
        handIn("cora", "arm-by-side", OWN.formatted("40").replace("error", "rest"));
        handIn("anna", "stop-at-30", start("stop-at-30").replace("}", "// 30\n}"));
        handIn("cora", "stop-at-30", start("stop-at-30").replace("}", "// 31\n}"));

        ClassTable table = table(CopyCheck.of(submissions));
        table.write(Files.createDirectories(folder.resolve("grades")));

        assertThat(table.sentence())
                .startsWith("3 pairs of programs are alike: see copies.csv. 1 exercise has too little");
        assertThat(Files.readAllLines(folder.resolve("grades/copies.csv")))
                .startsWith(
                        "exercise,student,other,alike percent,same numbers percent,note",
                        "03-arm-by-side,anna,ben,100,100,identical files")
                .endsWith("stop-at-30,,,,,0 of 2 programs have enough original code to compare");
        assertThat(Files.readString(folder.resolve("grades/grades.html")))
                .contains("3 pairs of programs are alike", "(stop-at-30: none of 2)", "identical files");
    }

    @Test
    void filesThatAreNoTextAreAlikeOnlyIfTheyAreIdentical() throws IOException {
        for (String student : List.of("anna", "ben", "cora")) {
            handIn(student, "stop-at-30", "class StopAt30 {\0}" + (student.equals("cora") ? "\0" : ""));
        }

        assertThat(CopyCheck.of(submissions).pairs())
                .singleElement()
                .matches(CopyCheck.Pair::identical)
                .matches(pair -> pair.first().equals("anna") && pair.second().equals("ben"));
    }

    private static String start(String exercise) {
        return Exercises.find(exercise).orElseThrow().startCode();
    }

    private void handIn(String student, String exercise, String text) throws IOException {
        Exercise task = Exercises.find(exercise).orElseThrow();
        Path file = Files.createDirectories(folder.resolve(student)).resolve(task.fileName());
        Files.writeString(file, text);
        submissions.add(new Submission(student, task, file, folder.resolve(student)));
    }

    private static String sentence(CopyCheck.Result result) {
        return table(result).sentence();
    }

    private static ClassTable table(CopyCheck.Result result) {
        return new ClassTable(Exercises.all(), List.of("anna"), List.of(), Map.of(), result, 3);
    }
}
