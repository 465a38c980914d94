package org.robonewbie.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;

import java.io.File;
import java.io.IOException;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.robonewbie.app.command.RoboNewbieCommand;
import org.robonewbie.nao.Joint;
import org.robonewbie.programs.ExampleCatalogue;

/** What the pages say is true: code compiles, commands exist, links lead somewhere, libraries are named. */
class DocumentationTest {

    private static final Pattern BLOCK = Pattern.compile("(?ms)^```(\\w+)\\R(.*?)^```");
    private static final Pattern LINK = Pattern.compile("\\]\\(([^)#]+)(#[^)]*)?\\)");
    private static final Pattern PUBLIC_CLASS = Pattern.compile("public (?:final )?class (\\w+)");
    private static final Pattern REFERENCE = Pattern.compile("(?:src|href)=\"([^\"]+)\"");
    private static final Pattern SLIDE_CODE = Pattern.compile("(?s)<pre>(.*?)</pre>");
    private static final Pattern TEST_NAME = Pattern.compile("(?:`|-Dtest=)([A-Z]\\w*Test)\\b");

    private static final List<String> TESTS = Project.sources("Test.java").stream()
            .map(file -> file.getFileName().toString().replace(".java", ""))
            .toList();
    private static final int MAX_LINES_OF_FIRST_PROGRAM = 12;

    @TempDir
    Path folder = Path.of("");

    static Stream<Path> pages() {
        return Project.pages().stream();
    }

    static Stream<Path> slides() throws IOException {
        try (Stream<Path> files = Files.list(Project.ROOT.resolve("docs/lectures/slides"))) {
            return files.filter(file -> file.toString().endsWith(".html")).toList().stream();
        }
    }

    @ParameterizedTest
    @MethodSource("pages")
    void codeCompiles(Path page) throws IOException {
        for (String code : blocks(page, "java")) {
            assertThat(mistakesIn(code)).as("%s%n%s", page, code).isEmpty();
        }
    }

    @ParameterizedTest
    @MethodSource("pages")
    void commandsExist(Path page) {
        blocks(page, "sh").stream()
                .flatMap(String::lines)
                .filter(line -> line.startsWith("./robonewbie"))
                .forEach(DocumentationTest::checkCommand);
    }

    @ParameterizedTest
    @MethodSource("pages")
    void linksLeadSomewhere(Path page) {
        List<String> broken = LINK.matcher(Project.read(page))
                .results()
                .map(match -> match.group(1))
                .filter(target -> !target.contains("://"))
                .filter(target -> !Files.exists(page.resolveSibling(target)))
                .toList();

        assertThat(broken).as(page.toString()).isEmpty();
    }

    @ParameterizedTest
    @MethodSource("pages")
    void namedTestsExist(Path page) {
        assertThat(TEST_NAME.matcher(Project.read(page)).results().map(match -> match.group(1)))
                .as(page.toString())
                .isSubsetOf(TESTS);
    }

    @ParameterizedTest
    @MethodSource("slides")
    void slidesHavePicturesAndCommandsThatExist(Path slides) {
        String text = Project.read(slides);

        assertThat(REFERENCE.matcher(text).results().map(match -> match.group(1)))
                .allMatch(target -> Files.exists(slides.resolveSibling(target)));
        SLIDE_CODE
                .matcher(text)
                .results()
                .map(code -> code.group(1).replaceAll("\\\\\\R *", ""))
                .filter(code -> code.startsWith("./robonewbie"))
                .forEach(DocumentationTest::checkCommand);
    }

    @Test
    void firstProgramIsShort() {
        String first = blocks(Project.ROOT.resolve("README.md"), "java").get(0);

        assertThat(first.lines()).hasSizeLessThanOrEqualTo(MAX_LINES_OF_FIRST_PROGRAM);
    }

    @Test
    void everyJointIsInTheTable() {
        String page = Project.read(Project.ROOT.resolve("docs/reference.md"));

        assertThat(Joint.values())
                .allSatisfy(joint -> assertThat(page)
                        .contains(String.format(
                                Locale.ROOT,
                                "| `%s` | %s | `%s` | `%s` | %.0f to %.0f |",
                                joint,
                                joint.standardName(),
                                joint.perceptorName(),
                                joint.effectorName(),
                                joint.minDegrees(),
                                joint.maxDegrees())));
    }

    @Test
    void everyLibraryOfTheProgramIsNamed() {
        String notice = Project.read(Project.ROOT.resolve("NOTICE"));
        Pattern forTests =
                Pattern.compile("robonewbie.*|junit.*|assertj.*|archunit.*|opentest4j.*|apiguardian.*|byte-buddy.*"
                        + "|japicmp.*|javassist.*|guava.*|failureaccess.*|listenablefuture.*|j2objc.*"
                        + "|surefire.*|jspecify.*|error_prone_annotations.*|classes|test-classes");

        List<String> libraries = Arrays.stream(
                        System.getProperty("java.class.path").split(File.pathSeparator, -1))
                .map(entry -> Path.of(entry).getFileName().toString())
                .filter(name -> !forTests.matcher(name).matches())
                .toList();

        assertThat(libraries).hasSizeGreaterThan(10).allSatisfy(library -> {
            String name = library.startsWith("jetty")
                    ? "Jetty"
                    : library.startsWith("core-") ? "ode4j" : library.replaceFirst("-\\d.*", "");
            assertThat(notice).contains(name).contains(library.replaceFirst(".*-(\\d[\\d.]*)\\.jar", "$1"));
        });
    }

    private static void checkCommand(String line) {
        String[] words = line.replaceFirst("\\s+#.*", "").split("\\s+", -1);
        String[] arguments = Arrays.copyOfRange(words, 1, words.length);

        assertThatCode(() -> RoboNewbieCommand.commandLine().parseArgs(arguments))
                .as(line)
                .doesNotThrowAnyException();
        if (arguments.length > 1 && arguments[0].equals("run") && !arguments[1].endsWith(".java")) {
            assertThat(ExampleCatalogue.classNames()).as(line).containsKey(arguments[1]);
        }
    }

    /** A page shows whole files, or a few lines of a method. */
    private String mistakesIn(String code) throws IOException {
        List<MatchResult> classes = PUBLIC_CLASS.matcher(code).results().toList();
        String name = classes.isEmpty() ? "Lines" : classes.get(0).group(1);
        String whole = classes.isEmpty()
                ? "import org.robonewbie.agent.*; import org.robonewbie.nao.*; class Lines { void run(String[] args) throws"
                        + " Exception {\n" + code + "\n} }"
                : code;
        Path file = Files.writeString(folder.resolve(name + ".java"), whole);
        var compiler = ToolProvider.getSystemJavaCompiler();
        StringWriter mistakes = new StringWriter();
        try (StandardJavaFileManager disk = compiler.getStandardFileManager(null, null, null)) {
            List<String> options = List.of("-proc:none", "-d", folder.toString());
            boolean correct = compiler.getTask(mistakes, disk, null, options, null, disk.getJavaFileObjects(file))
                    .call();
            return correct ? "" : mistakes.toString();
        }
    }

    private static List<String> blocks(Path page, String language) {
        return BLOCK.matcher(Project.read(page))
                .results()
                .filter(block -> block.group(1).equals(language))
                .map(block -> block.group(2))
                .toList();
    }
}
