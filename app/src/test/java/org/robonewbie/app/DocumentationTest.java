package org.robonewbie.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.robonewbie.app.page.CodeBlock;
import org.robonewbie.app.page.Command;

/** What the pages say is true: links lead somewhere, pictures are shown, libraries are named. */
class DocumentationTest {

    private static final Pattern LINK = Pattern.compile("\\]\\(([^)#]+)(#[^)]*)?\\)");
    private static final Pattern REFERENCE = Pattern.compile("(?:src|href)=\"([^\"]+)\"");
    private static final Pattern SLIDE_CODE = Pattern.compile("(?s)<pre>(.*?)</pre>");
    private static final Pattern TEST_NAME = Pattern.compile("(?:`|-Dtest=)([A-Z]\\w*Test)\\b");

    private static final List<String> TESTS = Project.sources("Test.java").stream()
            .map(file -> file.getFileName().toString().replace(".java", ""))
            .toList();
    private static final int MAX_LINES_OF_FIRST_PROGRAM = 12;

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
    void linksLeadSomewhere(Path page) {
        assertThat(targets(LINK, page)).as(page.toString()).allMatch(Files::exists);
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
        assertThat(targets(REFERENCE, slides)).allMatch(Files::exists);
        SLIDE_CODE
                .matcher(Project.read(slides))
                .results()
                .flatMap(code -> code.group(1).replaceAll("\\\\\\R *", "").lines())
                .flatMap(line -> Command.of(line).stream())
                .forEach(Command::assertValid);
    }

    @Test
    void everyPictureIsOnAPage() throws IOException {
        Set<Path> shown = Stream.concat(
                        CodeBlock.pages().flatMap(page -> targets(LINK, page)),
                        slides().flatMap(page -> targets(REFERENCE, page)))
                .collect(Collectors.toSet());

        try (Stream<Path> files = Files.walk(Project.ROOT.resolve("docs"))) {
            assertThat(files)
                    .filteredOn(file -> file.toString().matches(".*\\.(png|svg)"))
                    .allMatch(shown::contains);
        }
    }

    @Test
    void everyScreenshotIsMadeByATest() throws IOException {
        String tests = Project.sources(".test.js").stream().map(Project::read).collect(Collectors.joining());

        try (Stream<Path> files = Files.list(Project.ROOT.resolve("docs/images"))) {
            assertThat(files)
                    .map(file -> file.getFileName().toString())
                    .filteredOn(name -> name.endsWith(".png"))
                    .allMatch(name -> tests.contains("takesAPicture('" + name.replace(".png", "") + "'"));
        }
    }

    @Test
    void firstProgramIsShort() {
        String first = CodeBlock.on(Project.ROOT.resolve("README.md")).stream()
                .filter(CodeBlock::isAgent)
                .findFirst()
                .orElseThrow()
                .code();

        assertThat(first.lines()).hasSizeLessThanOrEqualTo(MAX_LINES_OF_FIRST_PROGRAM);
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

    /** Lists the files that a page refers to. */
    private static Stream<Path> targets(Pattern link, Path page) {
        return link.matcher(Project.read(page))
                .results()
                .map(match -> match.group(1))
                .filter(target -> !target.contains("://") && !target.startsWith("data:"))
                .map(target -> page.resolveSibling(target).normalize());
    }
}
