package org.robonewbie.app.page;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.robonewbie.app.ProcessResult;
import org.robonewbie.app.Python;
import org.robonewbie.programs.ClassPath;
import org.robonewbie.programs.process.JavaCommand;

/** A reader types all programs and commands of a page in their order, in an empty folder. */
@DisabledOnOs(value = OS.WINDOWS, disabledReason = "Python starts the simulator by a shell script")
@Tag("slow")
class PageRunTest {

    @TempDir
    private Path folder;

    /** Lists the pages that run something; of translations, the first. */
    static Stream<Path> pages() {
        Map<List<Object>, Path> pages = new LinkedHashMap<>();
        CodeBlock.pages().forEach(page -> pages.putIfAbsent(whatRunsOn(page), page));
        pages.remove(List.of());
        return pages.values().stream();
    }

    private static List<Object> whatRunsOn(Path page) {
        return CodeBlock.on(page).stream()
                .filter(CodeBlock::isRun)
                .flatMap(block -> switch (block.language()) {
                    case "java", "python" -> Stream.of(block.code());
                    default -> Stream.concat(block.commands().stream(), block.pythonModules().stream());
                })
                .toList();
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("pages")
    void pageRuns(Path page) throws Exception {
        for (CodeBlock block : CodeBlock.on(page)) {
            if (block.isRun()) {
                run(block);
            }
        }
    }

    private void run(CodeBlock block) throws Exception {
        if (block.fileName().isPresent()) {
            Files.writeString(folder.resolve(block.fileName().orElseThrow()), block.code());
        }
        switch (block.language()) {
            case "java" -> {
                Path file = Files.writeString(folder.resolve(block.className() + ".java"), block.sourceFile());
                if (block.isExperiment() && !isRunByACommand(file, block.page())) {
                    runCommands(block, List.of(new Command(List.of("run", file.toString()))));
                }
            }
            case "python" -> {
                Path program = Files.writeString(folder.resolve("program.py"), block.code());
                runPython(block, block.pythonImports(), program.toString());
            }
            default -> {
                runCommands(block, block.commands());
                for (String module : block.pythonModules()) {
                    String[] words = ("-m " + module).split(" ", -1);
                    runPython(block, "import " + words[1], words);
                }
            }
        }
    }

    private static boolean isRunByACommand(Path file, Path page) {
        String name = file.getFileName().toString();
        return CodeBlock.on(page).stream()
                .flatMap(block -> block.commands().stream())
                .anyMatch(command -> command.words().contains(name));
    }

    private void runCommands(CodeBlock block, List<Command> commands) throws Exception {
        List<String> arguments = commands.stream()
                .filter(Command::ends)
                .map(Command::forTest)
                .map(CommandRunner::argument)
                .toList();
        if (arguments.isEmpty()) {
            return;
        }
        ProcessBuilder builder = new ProcessBuilder(JavaCommand.of(
                        List.of("-Duser.home=" + folder),
                        ClassPath.ofThisProgram(),
                        CommandRunner.class.getName(),
                        arguments))
                .directory(folder.toFile());
        builder.environment().remove("ROBONEWBIE_PROGRESS");
        ProcessResult result = ProcessResult.of(builder);
        assertThat(result.code())
                .as("%s, command %d%n%s", block, result.code(), result.printed())
                .isZero();
        assertThat(result.printed()).as("%s", block).doesNotContain("failed with");
    }

    private void runPython(CodeBlock block, String imports, String... arguments) throws Exception {
        Python python = new Python(folder);
        if (python.canRun(imports)) {
            ProcessResult result = python.run(arguments);
            assertThat(result.code()).as("%s%n%s", block, result.printed()).isZero();
        }
    }
}
