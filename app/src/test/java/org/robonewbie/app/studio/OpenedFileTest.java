package org.robonewbie.app.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Which page opens for a file. */
class OpenedFileTest {

    @TempDir
    Path folder = Path.of("");

    @Test
    void programOpensInTheEditorWithItsSiblings() throws IOException {
        Path file = Files.writeString(folder.resolve("MyAgent.java"), "class MyAgent {}");

        OpenedFile opened = OpenedFile.of(Optional.of(file));

        assertThat(opened.place()).isEqualTo("#program/MyAgent.java");
        assertThat(opened.programs()).isEqualTo(folder);
    }

    @Test
    void programOfThisProjectOpensWithTheWholeProject() throws IOException {
        OpenedFile opened = OpenedFile.of(Optional.of(Path.of("src/main/java/org/robonewbie/app/Main.java")));

        assertThat(opened.place()).isEqualTo("#program/src%2Fmain%2Fjava%2Forg%2Frobonewbie%2Fapp%2FMain.java");
        assertThat(opened.programs()).isEqualTo(Path.of("").toAbsolutePath());
    }
}
