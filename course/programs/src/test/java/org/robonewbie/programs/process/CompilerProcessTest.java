package org.robonewbie.programs.process;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.robonewbie.programs.SourceFolder;
import org.robonewbie.programs.process.CompilerProcess.Answer;

class CompilerProcessTest {

    @TempDir
    private Path folder;

    @ParameterizedTest
    @EnumSource
    void correctSourcesBecomeClasses(Ground ground) throws IOException {
        Answer answer = compile(ground, "class Hello { public static void main(String[] args) {} }");

        assertThat(answer.isCorrect()).isTrue();
        assertThat(answer.classes()).containsExactly("Hello");
        assertThat(folder.resolve("classes/Hello.class")).exists();
    }

    @ParameterizedTest
    @EnumSource
    void mistakesAreReportedWithTheirLine(Ground ground) throws IOException {
        Answer answer = compile(ground, "class Hello {\n  int number = true;\n}\n");

        assertThat(answer.isCorrect()).isFalse();
        assertThat(answer.classes()).isEmpty();
        assertThat(String.join("\n", answer.lines())).contains("Hello.java:2: error: incompatible types");
    }

    private Answer compile(Ground ground, String text) throws IOException {
        Path sources = Files.createDirectories(folder.resolve("sources"));
        Files.writeString(sources.resolve("Hello.java"), text);
        return new CompilerProcess(ground.sandbox())
                .compile(new SourceFolder(sources, false), folder.resolve("classes"));
    }
}
