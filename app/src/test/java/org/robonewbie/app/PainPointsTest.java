package org.robonewbie.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

/** The list of the pain points of RoboNewbie 1.1 names tests that exist. */
class PainPointsTest {

    private static final int PAIN_POINTS = 38;
    private static final Pattern ROW = Pattern.compile("(?m)^\\| (\\d+) \\|.*`\\w+Test\\.\\w+` \\|$");
    private static final Pattern TEST = Pattern.compile("`(\\w+Test)\\.(\\w+)`");

    private final String page = Project.read(Project.ROOT.resolve("app/src/test/resources/pain-points.md"));

    @Test
    void eachPointNamesATest() {
        List<Integer> numbers = ROW.matcher(page)
                .results()
                .map(row -> Integer.valueOf(row.group(1)))
                .toList();

        assertThat(numbers).hasSize(PAIN_POINTS).isSorted().doesNotHaveDuplicates();
    }

    @Test
    void eachNamedTestExists() {
        List<Path> sources = Project.sources("Test.java");

        assertThat(TEST.matcher(page).results().filter(test -> !exists(test, sources)))
                .extracting(MatchResult::group)
                .isEmpty();
    }

    private static boolean exists(MatchResult test, List<Path> sources) {
        return sources.stream()
                .filter(file -> file.endsWith(test.group(1) + ".java"))
                .anyMatch(file -> Project.read(file).contains("void " + test.group(2) + "("));
    }
}
