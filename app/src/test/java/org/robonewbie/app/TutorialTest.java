package org.robonewbie.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Each whole program that a page shows really runs, and its robot makes no mistake. */
class TutorialTest {

    private static final Pattern PROGRAM =
            Pattern.compile("(?ms)^```java\\R((?:(?!^```).)*?public class (\\w+) extends Agent.*?)^```");

    @TempDir
    Path folder = Path.of("");

    /** A program on a page. */
    record Program(String page, String name, String code) {
        @Override
        public String toString() {
            return page + ": " + name;
        }
    }

    static Stream<Program> programs() {
        return Project.pages().stream().flatMap(page -> {
            Matcher matcher = PROGRAM.matcher(Project.read(page));
            return matcher.results()
                    .map(match ->
                            new Program(Project.ROOT.relativize(page).toString(), match.group(2), match.group(1)));
        });
    }

    @ParameterizedTest
    @MethodSource("programs")
    void programRuns(Program program) throws IOException {
        Path file = Files.writeString(folder.resolve(program.name() + ".java"), program.code());

        Printed printed = Printed.by("run", file.toString(), "--headless", "--fast", "--seed", "1", "--seconds", "5");

        assertThat(printed.exitCode()).as(printed.err()).isZero();
        assertThat(printed.err()).doesNotContain("failed with");
    }
}
