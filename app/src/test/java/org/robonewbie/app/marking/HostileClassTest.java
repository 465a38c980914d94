package org.robonewbie.app.marking;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Objects;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.robonewbie.app.Printed;
import org.robonewbie.nao.file.FolderLock;

/** What one student hands in costs no other one a mark, whatever it is. */
@EnabledOnOs(OS.LINUX)
class HostileClassTest {

    private static final String GOOD = """
            import org.robonewbie.agent.Agent;
            import org.robonewbie.nao.Joint;

            public class RaiseArms extends Agent {
                %s
                @Override
                protected void think() {
                    hold(Joint.LEFT_SHOULDER_PITCH, 60);
                    hold(Joint.RIGHT_SHOULDER_PITCH, 45);
                }

                private void hold(Joint joint, double degrees) {
                    double error = degrees - nao.getJointAngle(joint);
                    nao.setJointSpeed(joint, Math.abs(error) < 0.2 ? 0 : Math.max(-100, Math.min(100, 4 * error)));
                }
            }
            """;

    private static final String EVIL = """
            import org.robonewbie.agent.Agent;

            public class RaiseArms extends Agent {
                static {
                    try {
                        %s
                    } catch (Exception e) {
                        e.printStackTrace();
                    }
                }

                @Override
                protected void think() {}
            }
            """;

    @TempDir
    private Path folder;

    @BeforeEach
    void handIn() throws IOException {
        write("zoe/RaiseArms.java", GOOD.formatted(""));
    }

    private void write(String name, String text) throws IOException {
        Path file = folder.resolve("class").resolve(name);
        Files.createDirectories(Objects.requireNonNull(file.getParent()));
        Files.writeString(file, text);
    }

    private Printed grade() {
        return Printed.by(
                "grade",
                "raise-arms",
                "--seeds",
                "1",
                "--class",
                folder.resolve("class").toString());
    }

    private String grades() throws IOException {
        return Files.readString(folder.resolve("class-grades/grades.csv"));
    }

    /** Each command runs in the folder of all students. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            ln -s /dev/zero eve_RaiseArms.java                              | eve,,    | eve_RaiseArms.java is a link
            ln -s ../class/zoe/RaiseArms.java eve_RaiseArms.java            | eve,,    | eve_RaiseArms.java is a link
            ln -s nowhere eve_RaiseArms.java                                | eve,,    | eve_RaiseArms.java is a link
            mkfifo eve_RaiseArms.java                                       | eve,,    | is no regular file but a device
            ln -s zoe eve                                                   | eve,,    | class/eve is a link
            ln -s / eve                                                     | eve,,    | class/eve is a link
            mkdir eve; mkfifo eve/RaiseArms.java                            | eve,,    | eve/RaiseArms.java is no regular
            mkdir eve; mkfifo eve/data                                      | eve,,    | eve/data is no regular file
            mkdir eve; ln -s ../zoe/RaiseArms.java eve                      | eve,,    | leads out of the folder
            mkdir eve; ln -s /etc/passwd eve/Passwd.java                    | eve,,    | leads out of the folder
            mkdir eve; ln -s .. eve/up                                      | eve,,    | leads out of the folder
            mkdir -p eve/a; ln -s .. eve/a/up                               | eve,,    | in which it lies itself
            mkdir eve; truncate -s 3G eve/data.bin                          | eve,,    | has more than 100 MB
            mkdir eve; truncate -s 90M eve/RaiseArms.java                   | eve,0.0  | raise-arms
            cp -r zoe ./-rf; cp -r zoe 'new'$'\\n''line'                    | -rf,10.0 | new
            """)
    void badEntryIsOneLineAndTheOthersAreGraded(String command, String line, String note) throws Exception {
        shell(command);

        Printed printed = grade();

        assertThat(printed.exitCode()).as(printed.err()).isZero();
        assertThat(grades()).contains("zoe,10.0,10.0,1").contains("\n" + line).contains(note);
        assertThat(printed.out()).contains(" students, ").doesNotContain("new\nline");
    }

    @Test
    void markOfAnotherStudentCannotBeForged() throws IOException {
        String forged = """
                java.nio.file.Path kept = java.nio.file.Path.of("%s/kept/zoe");
                java.nio.file.Files.createDirectories(kept);
                java.nio.file.Path mark = kept.resolve("01-raise-arms.json");
                String text = java.nio.file.Files.exists(mark) ? java.nio.file.Files.readString(mark) : "{}";
                java.nio.file.Files.writeString(mark, text.replace("true", "false").replace(": 10", ": 0"));
                """.formatted(folder.resolve("class-grades"));
        grade();
        write("anna/RaiseArms.java", EVIL.formatted(forged));

        Printed again = grade();

        assertThat(again.out())
                .contains("1 of them graded before")
                .contains("Kept marks that were changed while programs ran, and are again as the judge gave them: 1.");
        assertThat(grades()).contains("zoe,10.0,10.0,1", "anna,0.0");
        assertThat(grade().out()).contains("2 of them graded before");
    }

    @Test
    void markWithoutTheSignatureOfTheJudgeIsNone() throws IOException {
        grade();
        Path mark = folder.resolve("class-grades/kept/zoe/01-raise-arms.json");
        Files.writeString(mark, Files.readString(mark).replace("\"passed\": true", "\"passed\": false"));

        assertThat(grade().out()).contains("0 of them graded before");
        assertThat(grades()).contains("zoe,10.0,10.0,1");
    }

    @Test
    void markOfOneStudentIsNoneOfAnother() throws IOException {
        write("anna/RaiseArms.java", GOOD.formatted("").replace("60", "10"));
        grade();
        Path kept = folder.resolve("class-grades/kept");
        write("anna/RaiseArms.java", GOOD.formatted(""));
        Files.writeString(
                kept.resolve("anna/01-raise-arms.json"), Files.readString(kept.resolve("zoe/01-raise-arms.json")));

        assertThat(grade().out()).contains("1 of them graded before");
    }

    @Test
    void nothingThatAProgramStartedOutlivesItsGrade() throws IOException {
        String seconds = "87871." + ProcessHandle.current().pid();
        write("anna/RaiseArms.java", EVIL.formatted("""
                for (String start : new String[] {"(setsid %1$s &)", "cd / && (setsid %1$s &)", "(env -i setsid %1$s &)"}) {
                    new ProcessBuilder("sh", "-c", start).start().waitFor();
                }
                """.formatted("sleep " + seconds)));

        Printed printed = grade();

        assertThat(printed.exitCode()).isZero();
        assertThat(ProcessHandle.allProcesses()
                        .filter(process ->
                                process.info().commandLine().orElse("").contains("sleep " + seconds)))
                .isEmpty();
        assertThat(grades()).contains("zoe,10.0,10.0,1", "anna,0.0,0.0,0");
    }

    @Test
    void filesOfAStudentAreReadBeforeAnyProgramRuns() throws IOException {
        write("anna/RaiseArms.java", EVIL.formatted("""
                java.nio.file.Path file = java.nio.file.Path.of("%s");
                java.nio.file.Files.writeString(file, "no program any more");
                """.formatted(folder.resolve("class/zoe/RaiseArms.java"))));

        grade();

        assertThat(grades()).contains("zoe,10.0,10.0,1");
    }

    @Test
    void compilerShowsNoLineOfAFileOutsideOfTheEntry() throws IOException {
        Path secret = Files.writeString(folder.resolve("class/Secret.java"), "the password is 1234");
        write("anna/RaiseArms.java", EVIL.formatted("Secret.tell(); Passwords.tell();"));
        write("anna/Passwords.java", "package other; class Passwords {}");

        Printed printed = grade();

        assertThat(printed.out() + grades()).contains("anna,0.0").doesNotContain("1234");
        assertThat(Files.readString(folder.resolve("class-grades/findings.csv")))
                .doesNotContain("1234");
        assertThat(secret).exists();
    }

    @Test
    void sourcesThatOvertaxTheCompilerCostTheirAuthor() throws IOException {
        write("anna/RaiseArms.java", EVIL.formatted("int x = " + "(".repeat(20_000) + "1" + ")".repeat(20_000) + ";"));

        Printed printed = grade();

        assertThat(printed.exitCode()).isZero();
        assertThat(grades()).contains("zoe,10.0,10.0,1", "anna,0.0,0.0,0,raise-arms: ");
    }

    @Test
    void secondGradingInTheSameFolderIsRefused() throws IOException {
        Path kept = Files.createDirectories(folder.resolve("class-grades/kept"));

        try (FolderLock other = FolderLock.take(kept.resolve("lock")).orElseThrow()) {
            Printed printed = grade();

            assertThat(other).isNotNull();
            assertThat(printed.exitCode()).isEqualTo(2);
            assertThat(printed.err())
                    .contains("Another grading is using the folder " + folder.resolve("class-grades")
                            + ". Wait for its end, or choose another folder with --results.");
        }
        assertThat(grade().exitCode()).isZero();
    }

    @Test
    void resultsWithinTheFolderOfTheClassAreNoStudent() throws IOException {
        Path results = folder.resolve("class/results");

        for (int i = 0; i < 2; i++) {
            Printed printed = Printed.by(
                    "grade",
                    "raise-arms",
                    "--seeds",
                    "1",
                    "--class",
                    folder.resolve("class").toString(),
                    "--results",
                    results.toString());
            assertThat(printed.out()).contains("1 students, 1 programs");
        }
    }

    @Test
    void keyOfTheJudgeIsReadableForItsOwnerOnly() throws IOException {
        Path file = folder.resolve("home/judges-key");

        String signature = JudgesKey.of(file).sign("a mark");

        assertThat(Files.getPosixFilePermissions(file)).isEqualTo(PosixFilePermissions.fromString("rw-------"));
        assertThat(JudgesKey.of(file).hasSigned("a mark", signature)).isTrue();
        assertThat(JudgesKey.of(file).hasSigned("another mark", signature)).isFalse();
        assertThat(JudgesKey.of(folder.resolve("other/judges-key")).hasSigned("a mark", signature))
                .isFalse();
    }

    private void shell(String command) throws Exception {
        Process process = new ProcessBuilder("bash", "-c", command)
                .directory(folder.resolve("class").toFile())
                .redirectErrorStream(true)
                .start();
        assertThat(new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8))
                .isEmpty();
        assertThat(process.waitFor()).isZero();
    }
}
