package org.robonewbie.app.command;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.app.Printed;
import org.robonewbie.exercises.Exercises;
import org.robonewbie.exercises.progress.ProgressFile;

class ProgressOptionTest {

    private static final Instant NOON = Instant.parse("2026-11-22T12:00:00Z");

    @TempDir
    private Path folder;

    private String member(String name, String exercise, double points, boolean passed) throws IOException {
        ProgressFile file = new ProgressFile(folder.resolve(name + ".json"));
        file.update(Exercises.find(exercise).orElseThrow(), state -> state.tried(points, passed, NOON));
        return file.file().toString();
    }

    @Test
    void teamCountsEachExerciseOnceAndGetsItsBadges() throws IOException {
        String anna = member("anna", "kick", 6, true);
        String ben = member("ben", "dance", 4.5, false);

        Printed printed = Printed.by("grade", "--progress", anna, ben);

        assertThat(printed.exitCode()).isZero();
        assertThat(printed.out())
                .contains("1 of " + Exercises.all().size() + " exercises passed, 10.5 of ")
                .contains("Badges: First success (one exercise passed)")
                .containsPattern("12 A kick of your own +passed +6.0 points");
    }

    @Test
    void teacherGetsATable() throws IOException {
        Path csv = folder.resolve("team.csv");

        Printed printed = Printed.by(
                "grade",
                "--progress",
                member("anna", "kick", 6, true),
                "--csv",
                csv.toString(),
                "--name",
                "Anna, \"A\"");

        assertThat(printed.exitCode()).isZero();
        assertThat(Files.readString(csv))
                .startsWith("name,exercise,passed,best points,tries,minutes,hints,solution seen,last\r\n")
                .contains("\"Anna, \"\"A\"\"\",12-kick,yes,6.0,1,0,0,no,2026-11-22T12:00:00Z\r\n");
    }

    @Test
    void missingFileIsSaid() {
        Printed printed =
                Printed.by("grade", "--progress", folder.resolve("nobody.json").toString());

        assertThat(printed.exitCode()).isEqualTo(2);
        assertThat(printed.err()).contains("There is no file");
    }
}
