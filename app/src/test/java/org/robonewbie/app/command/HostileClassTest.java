package org.robonewbie.app.command;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.app.Printed;
import org.robonewbie.nao.file.FolderLock;
import org.robonewbie.programs.process.Sandbox;

/** What one student hands in costs no other one a mark, whatever it is. */
@Tag("slow")
@EnabledOnOs(OS.LINUX)
class HostileClassTest {

    private static final String EVIL = """
            import org.robonewbie.agent.Agent;

            public class RaiseArms extends Agent {
                static {
                    try {
                        %s
                    } catch (Exception e) {
                        throw new IllegalStateException(e);
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
        write("zoe/RaiseArms.java", ClassMarkingTest.GOOD);
    }

    private void write(String name, String text) throws IOException {
        Path file = folder.resolve("class").resolve(name);
        Files.createDirectories(Objects.requireNonNull(file.getParent()));
        Files.writeString(file, text);
    }

    private Printed grade() {
        return grade("none");
    }

    private Printed grade(String fence) {
        boolean isRequired = System.getenv("ROBONEWBIE_REQUIRE_TOOLS") != null;
        assumeTrue(fence.equals("none") || isRequired || Sandbox.find().isUp(), "no fence here");
        return Printed.by(
                "grade",
                "raise-arms",
                "--seeds",
                "1",
                "--fence",
                fence,
                "--class",
                folder.resolve("class").toString());
    }

    private String grades() throws IOException {
        return Files.readString(folder.resolve("class-grades/grades.csv"));
    }

    /** What is handed in, made by a shell in the folder of all students, and what the table says of it. */
    private static final String BAD_ENTRIES = """
            ln -s /dev/zero e01_RaiseArms.java           | e01,,  | e01_RaiseArms.java is a link
            ln -s zoe/RaiseArms.java e02_RaiseArms.java  | e02,,  | e02_RaiseArms.java is a link
            ln -s nowhere e03_RaiseArms.java             | e03,,  | e03_RaiseArms.java is a link
            mkfifo e04_RaiseArms.java                    | e04,,  | e04_RaiseArms.java is not a regular file but a device
            ln -s zoe e05                                | e05,,  | e05 is a link
            ln -s / e06                                  | e06,,  | e06 is a link
            mkdir e07; mkfifo e07/RaiseArms.java         | e07,,  | e07/RaiseArms.java is not a regular file
            mkdir e08; mkfifo e08/data                   | e08,,  | e08/data is not a regular file
            mkdir e09; ln -s ../zoe/RaiseArms.java e09   | e09,,  | e09/RaiseArms.java is a link that leads out
            mkdir e10; ln -s /etc/passwd e10/Pass.java   | e10,,  | e10/Pass.java is a link that leads out
            mkdir e11; ln -s .. e11/up                   | e11,,  | e11/up is a link that leads out of the folder
            mkdir -p e12/a; ln -s .. e12/a/up            | e12,,  | e12/a/up is a link to a folder that contains it
            mkdir e13; truncate -s 3G e13/data.bin       | e13,,  | e13 contains more than 100 MB
            mkdir e14; ln -s . e14/self                  | e14,,  | e14/self is a link to a folder that contains it
            mkdir ./-rf                                  | '-rf,, | There is no .java file
            mkdir $'new\\nline'                          | "new   | line",,,,There is no .java file
            """;

    @ParameterizedTest
    @ValueSource(strings = {"none", "required"})
    void badEntriesAreALineEachAndTheOthersAreGraded(String fence) throws Exception {
        List<String[]> rows =
                BAD_ENTRIES.lines().map(row -> row.strip().split("\\s*\\|\\s*")).toList();
        for (String[] row : rows) {
            shell(row[0]);
        }

        Printed printed = grade(fence);

        assertThat(printed.exitCode()).as(printed.err()).isZero();
        assertThat(grades()).contains("zoe,10.0,10.0,1");
        assertThat(rows)
                .allSatisfy(row -> assertThat(grades()).contains("\n" + row[1]).contains(row[2]));
        assertThat(printed.out()).contains("17 students, 1 programs").doesNotContain("new\nline");
    }

    @ParameterizedTest
    @ValueSource(strings = {"none", "required"})
    void markOfAnotherStudentCannotBeForged(String fence) throws IOException {
        String forged = """
                java.nio.file.Path kept = java.nio.file.Path.of("%s/kept/zoe");
                java.nio.file.Files.createDirectories(kept);
                java.nio.file.Path mark = kept.resolve("01-raise-arms.json");
                String text = java.nio.file.Files.exists(mark) ? java.nio.file.Files.readString(mark) : "{}";
                java.nio.file.Files.writeString(mark, text.replace("true", "false").replace(": 10", ": 0"));
                """.formatted(folder.resolve("class-grades"));
        grade();
        write("anna/RaiseArms.java", EVIL.formatted(forged));

        Printed again = grade(fence);

        String repaired = "These stored grades were changed while programs were running and have been restored: 1.";
        assertThat(again.out()).contains("1 already graded");
        assertThat(again.out().contains(repaired)).isEqualTo(fence.equals("none"));
        assertThat(grades()).contains("zoe,10.0,10.0,1", "anna,0.0");
    }

    @Test
    void markWithoutTheSignatureOfTheJudgeIsNoneAndThatOfOneStudentIsNoneOfAnother() throws IOException {
        write("anna/RaiseArms.java", ClassMarkingTest.GOOD);
        grade();
        Path kept = folder.resolve("class-grades/kept");
        String mark = Files.readString(kept.resolve("zoe/01-raise-arms.json"));
        Files.writeString(kept.resolve("zoe/01-raise-arms.json"), mark.replace("true", "false"));
        Files.writeString(kept.resolve("anna/01-raise-arms.json"), mark);

        assertThat(grade().out()).contains("0 already graded");
        assertThat(grades()).contains("zoe,10.0,10.0,1");
    }

    @ParameterizedTest
    @ValueSource(strings = {"none", "required"})
    void whatProgramsDoToOthersCostsThemselvesOnly(String fence) throws IOException {
        String seconds = "87871." + ProcessHandle.current().pid();
        write("children/RaiseArms.java", EVIL.formatted("""
                for (String start : new String[] {"(setsid %1$s &)", "cd / && (setsid %1$s &)", "(env -i setsid %1$s &)"}) {
                    new ProcessBuilder("sh", "-c", start).start().waitFor();
                }
                """.formatted("sleep " + seconds)));
        write("vandal/RaiseArms.java", EVIL.formatted("""
                java.nio.file.Path file = java.nio.file.Path.of("%s");
                java.nio.file.Files.writeString(file, "no program any more");
                """.formatted(folder.resolve("class/zoe/RaiseArms.java"))));
        write("Secret.java", "the password is 1234");
        write("snoop/RaiseArms.java", EVIL.formatted("Secret.tell();"));
        write("deep/RaiseArms.java", EVIL.formatted("int x = " + "(".repeat(20_000) + "1" + ")".repeat(20_000) + ";"));

        Printed printed = grade(fence);

        assertThat(printed.exitCode()).as(printed.err()).isZero();
        assertThat(grades())
                .contains("zoe,10.0,10.0,1", "children,0.0,0.0,0", "vandal,0.0,0.0,0", "snoop,0.0,0.0,0")
                .contains("deep,0.0,0.0,0,raise-arms: It does not compile: expressions or blocks are nested")
                .doesNotContain("1234");
        assertThat(Files.readString(folder.resolve("class-grades/findings.csv")))
                .doesNotContain("1234");
        assertThat(ProcessHandle.allProcesses()
                        .filter(process ->
                                process.info().commandLine().orElse("").contains("sleep " + seconds)))
                .isEmpty();
    }

    @Test
    void secondGradingInTheSameFolderIsRefused() throws IOException {
        Path kept = Files.createDirectories(folder.resolve("class-grades/kept"));

        try (FolderLock other = FolderLock.take(kept.resolve("lock")).orElseThrow()) {
            Printed printed = grade();

            assertThat(other).isNotNull();
            assertThat(printed.exitCode()).isEqualTo(2);
            assertThat(printed.err())
                    .contains("Another grading run is using the folder " + folder.resolve("class-grades")
                            + ". Wait until it ends, or choose another folder with --results.");
        }
    }

    @Test
    void resultsWithinTheFolderOfTheClassAreNoStudent() throws IOException {
        Path results = folder.resolve("class/results");

        Files.createDirectories(results.resolve("kept"));

        Printed printed = Printed.by(
                "grade", "raise-arms", "--class", folder.resolve("class").toString(), "--results", results.toString());

        assertThat(printed.out()).contains("1 students, 1 programs");
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
