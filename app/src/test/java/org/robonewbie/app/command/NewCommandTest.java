package org.robonewbie.app.command;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.app.Printed;
import org.robonewbie.app.Project;

class NewCommandTest {

    @TempDir
    Path folder = Path.of("");

    @Test
    void projectHasAllItNeedsAndItsClassesCompile() throws IOException {
        Path jar = Files.writeString(folder.resolve("robonewbie.jar"), "the program");
        Path project = folder.resolve("my-team");

        new NewProject("my-team", "org.example.team", jar).create(project);

        assertThat(project.resolve("lib/robonewbie.jar")).hasSameBinaryContentAs(jar);
        assertThat(project.resolve("robonewbie")).isExecutable();
        assertThat(project.resolve("pom.xml")).content().contains("<artifactId>my-team</artifactId>");
        assertThat(project.resolve("motions/greet.txt")).isNotEmptyFile();
        assertThat(mistakesIn(project, "src/main/java/org/example/team/MyAgent.java"))
                .isEmpty();
        assertThat(mistakesIn(project, "src/test/java/org/example/team/MyAgentTest.java"))
                .isEmpty();
        try (Stream<Path> files = Files.walk(project)) {
            assertThat(files.filter(Files::isRegularFile).filter(file -> !file.endsWith("robonewbie.jar")))
                    .allSatisfy(file -> assertThat(file).content().doesNotContain("{{"));
        }
    }

    @Test
    void versionsOfThePluginsAreThoseOfRoboNewbie() throws IOException {
        Path jar = Files.writeString(folder.resolve("robonewbie.jar"), "the program");
        Path project = folder.resolve("my-team");
        String own = Project.read(Project.ROOT.resolve("pom.xml"));

        new NewProject("my-team", "team", jar).create(project);

        assertThat(Files.readString(project.resolve("pom.xml"))
                        .lines()
                        .filter(line -> line.matches(" *<version>\\d+\\.\\d+\\.\\d+</version>"))
                        .map(line -> line.replaceAll("[^\\d.]", "")))
                .hasSize(4)
                .allMatch(version -> own.contains(">" + version + "<"));
    }

    @Test
    void folderThatExistsIsKept() {
        Printed printed = Printed.by("new", folder.toString());

        assertThat(printed.exitCode()).isEqualTo(2);
    }

    @Test
    void nameThatIsNoneIsRefusedWithASentence() {
        Printed printed = Printed.by("new", "2 robots");

        assertThat(printed.exitCode()).isEqualTo(2);
        assertThat(printed.err())
                .contains("\"2 robots\" is no name for a project. Use letters, digits and -, such as my-team.");
    }

    @Test
    void packageThatIsNoneIsRefusedWithASentence() {
        Printed printed = Printed.by("new", folder.resolve("team").toString(), "--package", "My Team");

        assertThat(printed.exitCode()).isEqualTo(2);
        assertThat(printed.err()).contains("\"My Team\" is no name for a package.");
    }

    private String mistakesIn(Path project, String file) throws IOException {
        var compiler = ToolProvider.getSystemJavaCompiler();
        StringWriter mistakes = new StringWriter();
        try (var disk = compiler.getStandardFileManager(null, null, null)) {
            List<String> options = List.of(
                    "-proc:none",
                    "-sourcepath",
                    project.resolve("src/main/java").toString(),
                    "-d",
                    Files.createTempDirectory(folder, "classes").toString());
            return compiler.getTask(mistakes, disk, null, options, null, disk.getJavaFileObjects(project.resolve(file)))
                            .call()
                    ? ""
                    : mistakes.toString();
        }
    }
}
