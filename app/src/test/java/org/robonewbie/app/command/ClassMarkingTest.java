package org.robonewbie.app.command;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Objects;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.app.Printed;

/** A class has handed in good, bad, copied and broken programs. */
class ClassMarkingTest {

    /** Solves the exercise, and is long enough to be compared with others. */
    static final String GOOD = """
            import org.robonewbie.agent.Agent;
            import org.robonewbie.nao.Joint;

            public class RaiseArms extends Agent {
                @Override
                protected void think() {
                    hold(Joint.LEFT_SHOULDER_PITCH, 60);
                    hold(Joint.RIGHT_SHOULDER_PITCH, 45);
                }

                private void hold(Joint joint, double degrees) {
                    double error = degrees - nao.getJointAngle(joint);
                    double speed = Math.max(-100, Math.min(100, 4 * error));
                    nao.setJointSpeed(joint, Math.abs(error) < 0.2 ? 0 : speed);
                }
            }
            """;

    @TempDir
    private Path folder;

    @BeforeEach
    void handIn() throws IOException {
        write("anna/RaiseArms.java", GOOD);
        write("ben/homework/RaiseArms.java", GOOD.replace("hold", "raise").replace("error", "rest"));
        write("cora/RaiseArms.java", GOOD.replace("60);", "60)"));
        write("dora/Raisearms.java", GOOD);
        write("emil_RaiseArms.java", GOOD.replace("60", "10"));
        Files.createDirectories(folder.resolve("class/fritz"));
    }

    private void write(String name, String text) throws IOException {
        Path file = folder.resolve("class").resolve(name);
        Files.createDirectories(Objects.requireNonNull(file.getParent()));
        Files.writeString(file, text);
    }

    private Printed grade(String... more) {
        String[] words = {
            "grade",
            "raise-arms",
            "--seeds",
            "1",
            "--class",
            folder.resolve("class").toString()
        };
        return Printed.by(Stream.concat(Stream.of(words), Stream.of(more)).toArray(String[]::new));
    }

    @Tag("slow")
    @Test
    void allProgramsComeIntoOneTableWithReasonsAndCopies() throws IOException {
        Printed printed = grade();

        assertThat(printed.exitCode()).as(printed.err()).isZero();
        Path results = folder.resolve("class-grades");
        assertThat(Files.readAllLines(results.resolve("grades.csv")))
                .containsExactly(
                        "student,01-raise-arms,points,passed,note",
                        "anna,10.0,10.0,1,",
                        "ben,10.0,10.0,1,",
                        "cora,0.0,0.0,0,raise-arms: It does not compile: RaiseArms.java:7: ';' expected",
                        "dora,,,,No file is named after the class of an exercise. Is Raisearms.java meant to be"
                                + " RaiseArms.java?",
                        "emil,5.0,5.0,0,",
                        "fritz,,,,There is no .java file.");
        assertThat(Files.readString(results.resolve("copies.csv")))
                .contains("01-raise-arms,anna,ben,100,100")
                .contains("anna,emil");
        assertThat(Files.readString(results.resolve("grades.html")))
                .contains(
                        "<td class=\"passed\"",
                        "<td class=\"broken\" title=\"It does not compile",
                        "Programs that are alike");
        assertThat(printed.out()).contains("4 of 4").contains("6 students, 4 programs (0 already graded).");
    }

    @Tag("slow")
    @Test
    void onlyWhatHasChangedIsGradedAgain() throws IOException {
        grade();
        write("cora/RaiseArms.java", GOOD);
        Files.writeString(folder.resolve("class-grades/kept/anna/01-raise-arms.json"), "{ broken");

        Printed again = grade();

        assertThat(again.out()).contains("2 already graded");
        assertThat(Files.readString(folder.resolve("class-grades/grades.csv"))).contains("cora,10.0", "anna,10.0");
    }

    @Test
    void folderWithoutProgramsIsRefused() throws IOException {
        Path empty = Files.createDirectories(folder.resolve("empty"));

        Printed printed = Printed.by("grade", "--class", empty.toString());

        assertThat(printed.exitCode()).isEqualTo(2);
        assertThat(printed.err()).contains("contains no programs. It must contain a folder for each student");
    }

    @Test
    void programBesideAClassIsRefused() {
        Printed printed = grade("RaiseArms.java");

        assertThat(printed.exitCode()).isEqualTo(2);
    }
}
