package org.robonewbie.app.page;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;

import java.io.IOException;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.robonewbie.app.Printed;
import org.robonewbie.app.Project;

/** Every program of a page compiles and runs; every command exists, and runs in the order of its page. */
class PageCodeTest {

    private static final Pattern INLINE = Pattern.compile("`((?:\\./)?robonewbie [^`…]*)`");
    private static final JavaCompiler COMPILER = ToolProvider.getSystemJavaCompiler();

    /** Shared, since it reads the class path only once. */
    private static final StandardJavaFileManager CLASS_PATH =
            COMPILER.getStandardFileManager(null, null, StandardCharsets.UTF_8);

    @TempDir
    private Path folder;

    static Stream<CodeBlock> programs() {
        return CodeBlock.ofJava();
    }

    static Stream<CodeBlock> commands() {
        return CodeBlock.all().filter(block -> !block.commands().isEmpty());
    }

    static Stream<Path> pages() {
        return CodeBlock.pages();
    }

    @AfterAll
    static void close() throws IOException {
        CLASS_PATH.close();
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("programs")
    void programCompilesAndItsRobotMoves(CodeBlock block) throws IOException {
        assertThat(errors(block)).as("%s", block).isEmpty();

        if (block.isAgent() && block.isRun()) {
            List<String> words = List.of("run", "--class-path", folder.toString(), block.className());
            Printed printed = Printed.by(
                    new Command(words).with(block.options()).forTest().words().toArray(String[]::new));
            assertThat(printed.exitCode()).as("%s%n%s", block, printed.err()).isZero();
            assertThat(printed.err()).as("%s", block).doesNotContain("failed with");
        }
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("commands")
    void commandIsValid(CodeBlock block) {
        assertThat(block.commands()).as("%s", block).allSatisfy(Command::assertValid);
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("pages")
    void commandsInTheTextExist(Path page) {
        INLINE.matcher(Project.read(page))
                .results()
                .flatMap(span -> Command.of(span.group(1)).stream())
                .forEach(command ->
                        assertThatCode(command::assertKnown).as("%s", page).doesNotThrowAnyException());
    }

    private String errors(CodeBlock block) throws IOException {
        Path file = Files.writeString(folder.resolve(block.className() + ".java"), block.sourceFile());
        StringWriter errors = new StringWriter();
        List<String> options = List.of("-proc:none", "-d", folder.toString());
        boolean correct = COMPILER.getTask(errors, CLASS_PATH, null, options, null, CLASS_PATH.getJavaFileObjects(file))
                .call();
        return correct ? "" : errors.toString();
    }
}
