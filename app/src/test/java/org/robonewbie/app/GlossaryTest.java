package org.robonewbie.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The tutorial explains its words: each term of the glossary is a link to it where a page uses the term first. */
class GlossaryTest {

    private static final Pattern HEADING = Pattern.compile("(?m)^## (.+)$");
    private static final Pattern NO_PROSE = Pattern.compile("(?ms)^```.*?^```|`[^`\n]*`|^#[^\n]*$|!\\[[^]]*]\\([^)]*\\)"
            + "|\\[[^]]*]\\((?![^)]*glossary\\.md#)[^)]*\\)");

    static Stream<Path> pages() {
        return Project.pages().stream().filter(page -> page.startsWith(Project.ROOT.resolve("docs/tutorial")));
    }

    @ParameterizedTest
    @MethodSource("pages")
    void termIsALinkWhereItIsUsedFirst(Path page) {
        String prose = NO_PROSE.matcher(Project.read(page)).replaceAll(" ");

        assertThat(terms().stream().filter(term -> !isLinked(term, prose)))
                .as(page.toString())
                .isEmpty();
    }

    private static List<String> terms() {
        return HEADING.matcher(Project.read(Project.ROOT.resolve("docs/glossary.md")))
                .results()
                .map(heading -> heading.group(1).toLowerCase(Locale.ROOT))
                .toList();
    }

    private static boolean isLinked(String term, String prose) {
        Matcher use = Pattern.compile("\\b" + term + "(?:s|es)?\\b", Pattern.CASE_INSENSITIVE)
                .matcher(prose);
        if (!use.find()) {
            return true;
        }
        Pattern link = Pattern.compile("\\[[^]]*]\\([^)]*glossary\\.md#" + term.replace(' ', '-') + "\\)");
        return link.matcher(prose)
                .results()
                .findFirst()
                .filter(first -> holds(first, use.start()))
                .isPresent();
    }

    private static boolean holds(MatchResult link, int place) {
        return link.start() <= place && place < link.end();
    }
}
