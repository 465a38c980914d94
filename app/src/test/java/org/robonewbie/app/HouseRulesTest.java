package org.robonewbie.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Predicate;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

/** Rules of the house that no compiler checks. */
class HouseRulesTest {

    /** Sleeping, spinning, and loops that look at the clock and do nothing else. */
    private static final Pattern SLEEP_OR_SPIN = Pattern.compile("\\b(Thread\\.sleep|parkNanos|onSpinWait)\\("
            + "|TimeUnit\\.\\w+\\.sleep\\(|while \\([^;{}]*nanoTime\\(\\)[^;{}]*\\) *\\{\\s*\\}");

    /** Programs that a test writes down may well sleep. */
    private static final Pattern TEXT = Pattern.compile("\"\"\"(?s:.*?)\"\"\"|\"(?:\\\\.|[^\"\\\\\\n])*\"");

    private static final Pattern RAW_TRACE = Pattern.compile("\\.printStackTrace\\(\\s*\\)");
    private static final Pattern OPEN_END = Pattern.compile("\\b(TODO|FIXME|XXX)\\b");

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
