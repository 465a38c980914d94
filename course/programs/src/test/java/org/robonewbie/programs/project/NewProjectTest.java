package org.robonewbie.programs.project;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.robonewbie.programs.CalledWronglyException;
import org.robonewbie.programs.SourceFolder;
import org.robonewbie.programs.project.NewProject.BuildTool;
import org.robonewbie.programs.project.NewProject.Origin;

class NewProjectTest {

    @TempDir
    private Path folder;

    private Path project;
    private Path jar;

    @BeforeEach
    void createJars() throws IOException {
        project = folder.resolve("stars");
        jar = Files.writeString(folder.resolve("robonewbie.jar"), "classes");
        Files.writeString(folder.resolve("robonewbie-sources.jar"), "sources");
    }

    @ParameterizedTest
    @CsvSource({"MAVEN, pom.xml, build.gradle", "GRADLE, build.gradle, pom.xml"})
    void projectHasTheFilesOfItsBuildTool(BuildTool tool, String file, String other) throws IOException {
        create(tool, Origin.AGENT);

        assertThat(project.resolve(file)).content().contains("2.0.0").doesNotContain("{{");
        assertThat(project.resolve(other)).doesNotExist();
        assertThat(project.resolve("README.md")).content().contains("stars").doesNotContain("{{");
        assertThat(project.resolve("robonewbie")).isExecutable();
        assertThat(project.resolve("robonewbie.cmd")).content().contains("\r\n");
        assertThat(project.resolve("motions/greet.txt")).isNotEmptyFile();
    }

    @Test
    void agentOfAProjectCompiles() throws IOException {
        create(BuildTool.MAVEN, Origin.AGENT);

        List<String> programs =
                new SourceFolder(project, true).compile(Files.createDirectory(folder.resolve("classes")));

        assertThat(programs).containsExactly("de.stars.MyAgent");
    }

    @Test
    void repositoryOfAProjectHasTheJarsThatExist() throws IOException {
        create(BuildTool.MAVEN, Origin.AGENT);

        Path repository = project.resolve("lib/org/robonewbie/robonewbie/2.0.0");
        assertThat(repository.resolve("robonewbie-2.0.0.jar")).hasContent("classes");
        assertThat(repository.resolve("robonewbie-2.0.0-sources.jar")).hasContent("sources");
        assertThat(repository.resolve("robonewbie-2.0.0-javadoc.jar")).doesNotExist();
        assertThat(repository.resolve("robonewbie-2.0.0.pom")).content().contains("<version>2.0.0</version>");
    }

    @Test
    void missingFilesAreNamed() throws IOException {
        assertThatThrownBy(() -> create(BuildTool.MAVEN, Origin.TEAM))
                .isInstanceOf(CalledWronglyException.class)
                .hasMessageStartingWith("This build lacks the sources of the example team.");
        Files.delete(jar);
        assertThatThrownBy(() -> create(BuildTool.MAVEN, Origin.AGENT))
                .isInstanceOf(CalledWronglyException.class)
                .hasMessageContaining("robonewbie.jar, which does not exist.");
    }

    private void create(BuildTool tool, Origin origin) throws IOException {
        new NewProject("stars", "de.stars", tool, origin, NewProject.Robot.NAO, jar, "2.0.0").create(project);
    }
}
