package org.robonewbie.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.List;
import java.util.function.Predicate;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

/** Rules of the house that no compiler checks. */
class HouseRulesTest {

    private static final int MOST_HOMONYMS = 3;
    private static final Pattern EMPTY_NAME = Pattern.compile(".*(Util|Utils|Manager|Helper|Impl)\\.(java|js)");

    /** Sleeping, spinning, and loops that look at the clock and do nothing else. */
    private static final Pattern SLEEP_OR_SPIN = Pattern.compile("\\b(Thread\\.sleep|parkNanos|onSpinWait)\\("
            + "|TimeUnit\\.\\w+\\.sleep\\(|while \\([^;{}]*nanoTime\\(\\)[^;{}]*\\) *\\{\\s*\\}");

    /** Programs that a test writes down may well sleep. */
    private static final Pattern TEXT = Pattern.compile("\"\"\"(?s:.*?)\"\"\"|\"(?:\\\\.|[^\"\\\\\\n])*\"");

    /** Phrases that are not idiomatic English, in comments and messages. */
    private static final Pattern QUAINT =
            Pattern.compile("\\b(Tells (whether|how|what|which|where|who|when|why)|[Ww]ho overrides|[Ww]ho wants"
                    + "|the own (team|goal|half|side|head|program|folder|port)|[Ff]inds somebody|anew|shall)\\b");

    private static final Pattern RAW_TRACE = Pattern.compile("\\.printStackTrace\\(\\s*\\)");
    private static final Pattern OPEN_END = Pattern.compile("\\b(TODO|FIXME|XXX)\\b");

    @Test
    void namesSayWhatAThingIs() {
        List<Path> all = Project.sources("");

        assertThat(those(
                        all,
                        file -> EMPTY_NAME
                                .matcher(file.getFileName().toString())
                                .matches()))
                .isEmpty();
    }

    @Test
    void hardlyTwoClassesShareAName() {
        List<String> names = Project.productSources(".java").stream()
                .map(file -> file.getFileName().toString())
                .filter(name -> !name.equals("package-info.java"))
                .toList();

        assertThat(names.stream().filter(name -> Collections.frequency(names, name) > 1))
                .hasSizeLessThanOrEqualTo(2 * MOST_HOMONYMS);
    }

    @Test
    void exceptionsAreToldInWords() {
        assertThat(those(
                        Project.sources(".java"),
                        file -> RAW_TRACE.matcher(Project.read(file)).find()))
                .isEmpty();
    }

    @Test
    void testsWaitForEventsAndNeitherSleepNorSpin() {
        List<Path> product = Project.productSources(".java");
        List<Path> testSources = Project.sources(".java").stream()
                .filter(file -> !product.contains(file))
                .toList();

        assertThat(those(
                        testSources,
                        file -> !isThisTest(file)
                                && SLEEP_OR_SPIN
                                        .matcher(
                                                TEXT.matcher(Project.read(file)).replaceAll("\"\""))
                                        .find()))
                .isEmpty();
    }

    @Test
    void commentsAndMessagesAreIdiomatic() {
        assertThat(those(
                        Project.productSources(".java"),
                        file -> QUAINT.matcher(Project.read(file)).find()))
                .isEmpty();
    }

    @Test
    void nothingIsLeftOpenInTheSources() {
        assertThat(those(
                        Project.sources(".java"),
                        file -> !isThisTest(file)
                                && OPEN_END.matcher(Project.read(file)).find()))
                .isEmpty();
    }

    @Test
    void everyPackageSaysWhatLivesThere() {
        List<Path> withoutWord = those(
                Project.productSources(".java"),
                file -> !Files.exists(file.resolveSibling("package-info.java")) && !file.endsWith("module-info.java"));

        assertThat(withoutWord).isEmpty();
    }

    @Test
    void everyPackageIsFreeOfNull() {
        List<Path> packages = those(Project.sources("package-info.java"), file -> true);

        assertThat(packages)
                .isNotEmpty()
                .allMatch(file ->
                        Project.read(Project.ROOT.resolve(file)).contains("@org.jspecify.annotations.NullMarked"));
    }

    private static List<Path> those(List<Path> files, Predicate<Path> condition) {
        return files.stream().filter(condition).map(Project.ROOT::relativize).toList();
    }

    private static boolean isThisTest(Path file) {
        return file.endsWith("HouseRulesTest.java");
    }
}
