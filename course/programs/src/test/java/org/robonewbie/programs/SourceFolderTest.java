package org.robonewbie.programs;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class SourceFolderTest {

    private static final String MAIN = "public static void main(String[] args) {}";

    @TempDir
    private Path folder;

    @Test
    void programsOfAProjectAreThoseWithAMainMethod() throws IOException {
        write("src/main/java/a/Player.java", "package a; public class Player { " + MAIN + " Ball ball; }");
        write("src/main/java/a/Ball.java", "package a; class Ball {}");
        write("src/main/java/module-info.java", "module a {}");

        assertThat(new SourceFolder(folder, true).compile(folder.resolve("classes")))
                .containsExactly("a.Player");
        assertThat(folder.resolve("classes/a/Ball.class")).exists();
    }

    @Test
    void foldersInAFolderAreLeftOutUnlessItIsDeep() throws IOException {
        write("deeper/Player.java", "class Player {}");

        assertThat(new SourceFolder(folder, false).hasSources()).isFalse();
        assertThat(new SourceFolder(folder, true).hasSources()).isTrue();
    }

    @Test
    void classPathHasClassesResourcesAndLibraries() throws IOException {
        Files.createDirectories(folder.resolve("src/main/resources"));
        Files.createDirectories(folder.resolve("src/main/java"));
        write("lib/maths.jar", "");
        write("lib/readme.txt", "");

        assertThat(new SourceFolder(folder, true).classPath(folder.resolve("classes")))
                .containsExactly(
                        folder.resolve("src/main/resources"),
                        folder.resolve("src/main/java"),
                        folder.resolve("lib/maths.jar"));
    }

    @Test
    void mistakesStopTheCompilation() throws IOException {
        write("Player.java", "class Player { int number = true; }");

        assertThatThrownBy(() -> new SourceFolder(folder, false).compile(folder.resolve("classes")))
                .isInstanceOf(CompilationFailedException.class);
    }

    private void write(String name, String text) throws IOException {
        Path file = folder.resolve(name);
        Files.createDirectories(file.getParent());
        Files.writeString(file, text);
    }
}
