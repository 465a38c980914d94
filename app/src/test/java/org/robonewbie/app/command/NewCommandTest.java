package org.robonewbie.app.command;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.io.IOException;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.app.Printed;
import org.robonewbie.app.Project;
import org.robonewbie.programs.project.NewProject;
import org.robonewbie.programs.project.NewProject.BuildTool;

class NewCommandTest {

    private static final String LIBRARY = "lib/org/robonewbie/robonewbie/2.0.0/robonewbie-2.0.0";

    @TempDir
    Path folder = Path.of("");

    @Test
    void projectHasAllItNeedsAndItsClassesCompile() throws IOException {
        Path jar = Files.writeString(folder.resolve("robonewbie.jar"), "the program");
        Path sources = Files.writeString(folder.resolve("robonewbie-sources.jar"), "its sources");
        Path project = folder.resolve("my-team");

        new NewProject(
                        "my-team",
                        "org.example.team",
                        BuildTool.MAVEN,
                        NewProject.Origin.AGENT,
                        NewProject.Robot.NAO,
                        jar,
                        "2.0.0")
                .create(project);

        assertThat(project.resolve(LIBRARY + ".jar")).hasSameBinaryContentAs(jar);
        assertThat(project.resolve(LIBRARY + "-sources.jar")).hasSameBinaryContentAs(sources);
        assertThat(project.resolve(LIBRARY + ".pom")).content().contains("<version>2.0.0</version>");
        assertThat(project.resolve("robonewbie")).isExecutable();
        assertThat(project.resolve("pom.xml")).content().contains("<artifactId>my-team</artifactId>");
        assertThat(project.resolve("motions/greet.txt")).isNotEmptyFile();
        assertThat(mistakesIn(project, "src/main/java/org/example/team/MyAgent.java"))
                .isEmpty();
        assertThat(mistakesIn(project, "src/test/java/org/example/team/MyAgentTest.java"))
                .isEmpty();
        try (Stream<Path> files = Files.walk(project)) {
            assertThat(files.filter(Files::isRegularFile))
                    .allSatisfy(file -> assertThat(file).content().doesNotContain("{{"));
        }
    }

    @Test
    void projectFromTheTeamHasTheWholeTeamInThePackageOfTheStudent() throws IOException {
        Path jar = Files.writeString(folder.resolve("robonewbie.jar"), "the program");
        Path project = folder.resolve("my-team");

        new NewProject(
                        "my-team",
                        "org.example.team",
                        BuildTool.MAVEN,
                        NewProject.Origin.TEAM,
                        NewProject.Robot.NAO,
                        jar,
                        "2.0")
                .create(project);

        assertThat(mistakesIn(project, "src/main/java/org/example/team/MyAgent.java"))
                .isEmpty();
        assertThat(project.resolve("src/main/java/org/example/team/tactics/Strategy.java"))
                .content()
                .doesNotContain("org.robonewbie.team");
        assertThat(project.resolve("README.md"))
                .content()
                .contains("## Your team", "src/main/java/org/example/team/MyAgent.java 11 --team Mine")
                .doesNotContain("{{");
    }

    @Test
    void versionsOfThePluginsAreThoseOfRoboNewbie() throws IOException {
        Path jar = Files.writeString(folder.resolve("robonewbie.jar"), "the program");
        Path project = folder.resolve("my-team");
        String own = Project.read(Project.ROOT.resolve("pom.xml"));

        new NewProject("my-team", "team", BuildTool.MAVEN, NewProject.Origin.AGENT, NewProject.Robot.NAO, jar, "2.0")
                .create(project);

        assertThat(Files.readString(project.resolve("pom.xml"))
                        .lines()
                        .filter(line -> line.matches(" *<version>\\d+\\.\\d+\\.\\d+</version>"))
                        .map(line -> line.replaceAll("[^\\d.]", "")))
                .hasSize(4)
                .allMatch(version -> own.contains(">" + version + "<"));
    }

    @Test
    void projectForGradleHasItsFilesInsteadOfThoseOfMaven() throws IOException {
        Path jar = Files.writeString(folder.resolve("robonewbie.jar"), "the program");
        Path project = folder.resolve("my-team");

        new NewProject("my-team", "team", BuildTool.GRADLE, NewProject.Origin.AGENT, NewProject.Robot.NAO, jar, "2.0.0")
                .create(project);

        assertThat(project.resolve("build.gradle"))
                .content()
                .contains("org.robonewbie:robonewbie:2.0.0", "team.MyAgent");
        assertThat(project.resolve("pom.xml")).doesNotExist();
    }

    @Test
    void versionIdentifiesTheJar() throws IOException {
        Path release = Files.writeString(folder.resolve("robonewbie-2.0.0.jar"), "the program");
        Path built = Files.writeString(folder.resolve("robonewbie.jar"), "the program");

        assertThat(ProgramVersion.of(release, "2.0.0", "0839a708")).isEqualTo("2.0.0");
        assertThat(ProgramVersion.of(built, "2.0.0", "0839a708")).isEqualTo("2.0.0-0839a708");
        assertThat(ProgramVersion.of(built, "2.0.0", "0839a708-modified")).isEqualTo("2.0.0-0839a708-modified-74fda5e");
        assertThat(ProgramVersion.of(built, "2.0.0", "")).isEqualTo("2.0.0-built-74fda5e");
    }

    @Test
    void projectForAT1HasItsOwnTestAndSettings() throws IOException {
        Path jar = Files.writeString(folder.resolve("robonewbie.jar"), "the program");
        Path project = folder.resolve("my-team");

        new NewProject("my-team", "team", BuildTool.MAVEN, NewProject.Origin.AGENT, NewProject.Robot.T1, jar, "2.0.0")
                .create(project);

        assertThat(project.resolve("robonewbie.properties")).content().contains("robot = T1");
        assertThat(project.resolve("README.md"))
                .content()
                .contains("pip install rcsssmj==0.2.1")
                .doesNotContain("{{");
        assertThat(mistakesIn(project, "src/main/java/team/MyAgent.java")).isEmpty();
        assertThat(mistakesIn(project, "src/test/java/team/MyAgentTest.java")).isEmpty();
        assertThat(mistakesIn(project, "src/test/java/team/T1Test.java")).isEmpty();
    }

    @Test
    void teamOfT1HasTheSourcesOfTheTeamAndTheSettingsOfT1() throws IOException {
        Path jar = Files.writeString(folder.resolve("robonewbie.jar"), "the program");
        Path project = folder.resolve("my-team");

        new NewProject("my-team", "team", BuildTool.MAVEN, NewProject.Origin.TEAM, NewProject.Robot.T1, jar, "2.0")
                .create(project);

        assertThat(project.resolve("src/main/java/team/tactics/Strategy.java")).exists();
        assertThat(project.resolve("robonewbie.properties")).content().contains("robot = T1");
        assertThat(project.resolve("README.md")).content().contains("## Your team", "## Your T1");
    }

    @Test
    void robotIsNoOrigin() {
        Printed printed = Printed.by("new", folder.resolve("team").toString(), "--from", "t1");

        assertThat(printed.exitCode()).isEqualTo(2);
        assertThat(printed.err()).contains("--from");
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
                .contains("\"2 robots\" is not a valid project name. Use letters, digits and -, such as my-team.");
    }

    @DisabledOnOs(OS.WINDOWS)
    @ParameterizedTest
    @ValueSource(strings = {"a:b", "x\uD83D\uDCBB"})
    void folderInWhichNoToolCanBuildIsRefusedByItsCharacter(String name) {
        assumeThat(System.getProperty("sun.jnu.encoding")).isEqualTo("UTF-8");
        Path project = folder.resolve(name).resolve("team");

        Printed printed = Printed.by("new", project.toString());

        assertThat(printed.exitCode()).isEqualTo(2);
        assertThat(printed.err())
                .contains("whose path contains the character \""
                        + name.substring(1).replace("b", "") + "\": ");
        assertThat(folder.resolve(name)).doesNotExist();
    }

    @Test
    void projectNamesItsRepositoryByAnAddressAndTheEncodingOfItsSources() throws IOException {
        Path jar = Files.writeString(folder.resolve("robonewbie.jar"), "the program");
        Path project = folder.resolve("my-team");

        new NewProject("my-team", "team", BuildTool.MAVEN, NewProject.Origin.AGENT, NewProject.Robot.NAO, jar, "2.0")
                .create(project);

        assertThat(project.resolve("pom.xml")).content().contains("<url>${project.baseUri}lib</url>");
        assertThat(project.resolve("README.md")).content().contains("javac -encoding UTF-8 ");
    }

    @Test
    void packageThatIsNoneIsRefusedWithASentence() {
        Printed printed = Printed.by("new", folder.resolve("team").toString(), "--package", "My Team");

        assertThat(printed.exitCode()).isEqualTo(2);
        assertThat(printed.err()).contains("\"My Team\" is not a valid package name.");
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
