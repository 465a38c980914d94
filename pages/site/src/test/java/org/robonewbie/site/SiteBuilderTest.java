package org.robonewbie.site;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Sites of a small project and of this one are complete, with working links and without external resources. */
class SiteBuilderTest {

    private static final Pattern REFERENCE = Pattern.compile("(?:href|src)=\"([^\"]+)\"");

    @TempDir
    Path project = Path.of("");

    @TempDir
    Path site = Path.of("");

    @BeforeEach
    void makeSmallProject() throws IOException {
        page("docs/README.md", "# Start\n\n## Learn\n\n- [Walk](lessons/README.md)\n- [Rules](rules.md)\n");
        page("docs/lessons/README.md", "# Walking\n\nSee [how](1-step.md#one-step-more).\n");
        page(
                "docs/lessons/1-step.md",
                "# A step\n\n## One step, more!\n\n[back](../README.md), [code](../../Step.java)\n");
        page("docs/rules.md", "# Rules\n\n| a | b |\n|---|---|\n| 1 | x < y |\n");
        page("README.md", "# Read me\n");
        page("research/python/README.md", "# Python\n");
        page("Step.java", "class Step { boolean isLess = 1 < 2; }");
    }

    @Test
    void linksBetweenFilesBecomeLinksBetweenPages() throws IOException {
        build(project);

        assertThat(read("lessons/index.html")).contains("<a href=\"1-step.html#one-step-more\">how</a>");
        assertThat(read("lessons/1-step.html"))
                .contains("<h2 id=\"one-step-more\">")
                .contains("<a href=\"../index.html\">back</a>");
    }

    @Test
    void emptyCornerOfATableIsNoHead() throws IOException {
        page("docs/rules.md", "# Rules\n\n| | red |\n|---|---|\n| goals | 1 |\n");

        build(project);

        assertThat(read("rules.html"))
                .contains("<td></td>")
                .contains("<th>red</th>")
                .doesNotContain("<th></th>");
    }

    @Test
    void searchIndexHasNoCommentsOfWriters() throws IOException {
        page("docs/rules.md", "# Rules\n\n<!-- generated: rules -->\n\n| red |\n|---|\n| goals |\n\n<!-- end -->\n");

        build(project);

        assertThat(read("rules.html")).contains("<th>red</th>");
        assertThat(read("search-index.js")).contains("goals").doesNotContain("generated");
    }

    @Test
    void linkToSourceFileShowsIt() throws IOException {
        build(project);

        assertThat(read("lessons/1-step.html")).contains("<a href=\"../files/step.java.html\">code</a>");
        assertThat(read("files/step.java.html")).contains("isLess = 1 &lt; 2;");
    }

    @Test
    void everyPageShowsVersionAndNavigation() throws IOException {
        build(project);

        assertThat(read("lessons/1-step.html"))
                .contains("RoboNewbie 1.2.3")
                .contains("<a href=\"1-step.html\" aria-current=\"page\">A step</a>")
                .contains("<a href=\"index.html\" rel=\"prev\">Walking</a>")
                .contains("<a href=\"../rules.html\" rel=\"next\">Rules</a>");
    }

    @Test
    void pageOfAReaderListsOnlyItsChapter() throws IOException {
        page(
                "docs/README.md",
                "# Start\n\n## Students\n\n[Walk](lessons/README.md)\n\n## Teachers\n\n[Rules](rules.md)\n");

        build(project);

        assertThat(read("for/students.html"))
                .contains("<h1 id=\"students\">Students</h1>", "<a href=\"../lessons/index.html\">Walk</a>")
                .contains("<a href=\"../index.html\">All documentation</a>")
                .doesNotContain("Rules", "Teachers");
        assertThat(read("lessons/1-step.html"))
                .contains("<a href=\"../for/students.html\">Students</a>", "data-part=\"Students\"")
                .doesNotContain("Rules");
        assertThat(read("index.html")).contains("<section><h2 id=\"students\">", "Rules", "for/teachers.html");
    }

    @Test
    void searchIndexHasEverySection() throws IOException {
        build(project);

        assertThat(read("search-index.js"))
                .startsWith("globalThis.searchIndex = [")
                .contains("\"address\":\"lessons/1-step.html#one-step-more\",\"language\":\"en\"")
                .contains("\"part\":\"Learn\"");
    }

    @Test
    void brokenLinkFailsTheBuild() throws IOException {
        page("docs/rules.md", "# Rules\n\n[gone](gone.md), [no heading](README.md#nothing)\n");

        assertThatThrownBy(() -> build(project))
                .isInstanceOf(BrokenLinksException.class)
                .hasMessageContaining("docs/rules.md: missing file in link gone.md")
                .hasMessageContaining("docs/rules.md: missing heading in link README.md#nothing");
    }

    @Test
    void siteOfThisProjectIsWhole() throws IOException {
        build(projectRoot());
        List<Path> pages = files(".html");
        new ApiPages(projectRoot(), "1.2.3").build(site);

        assertThat(pages).hasSizeGreaterThan(60);
        for (Path page : pages) {
            assertThat(missingFiles(page)).as(page.toString()).isEmpty();
        }
    }

    @Test
    void everyPageOfThisProjectIsInTheList() throws IOException {
        build(projectRoot());

        Set<String> listed = new HashSet<>();
        List<Path> framed = new ArrayList<>(); // slides and cards have no navigation
        for (Path page : files(".html")) {
            if (Files.readString(page).contains("<nav aria-label=\"Pages\">")) {
                framed.add(page);
            }
        }
        for (Path page : framed) {
            String list = Files.readString(page).replaceFirst("(?s).*?<nav aria-label=\"Pages\">(.*?)</nav>.*", "$1");
            references(list)
                    .map(address -> nameOf(page.resolveSibling(address)))
                    .forEach(listed::add);
        }
        List<String> pages = framed.stream()
                .map(this::nameOf)
                .filter(name -> !name.startsWith("files/") && !name.equals("index.html"))
                .toList();
        assertThat(listed).containsAll(pages);
    }

    @Test
    void slidesCardAndWorksheetsAreReadyForPaper() throws IOException {
        build(projectRoot());

        assertThat(site.resolve("lectures/slides/1-robots.html")).exists();
        assertThat(site.resolve("lectures/slides/slides.css")).exists();
        assertThat(site.resolve("teaching/api-card.html")).exists();
        assertThat(site.resolve("print.css")).content().contains("A4", ".worksheet");
        assertThat(site.resolve("exercises/12-kick.html")).content().contains("class=\"worksheet\"", "lang=\"en\"");
        assertThat(site.resolve("exercises/de/12-kick.html")).content().contains("class=\"worksheet\"", "lang=\"de\"");
        assertThat(site.resolve("exercises/index.html")).content().doesNotContain("class=\"worksheet\"");
    }

    @Test
    void worksheetHasGoalCommandsAndTimesOfItsExercise() throws IOException {
        build(projectRoot());

        assertThat(read("exercises/12-kick.html"))
                .contains("<strong>Goal</strong>: Kick the ball 2 m or more")
                .contains("<h2 id=\"begin\">", "./robonewbie grade kick --start", "120 minutes", "12 seconds")
                .contains("<a href=\"de/12-kick.html\">");
        assertThat(read("exercises/de/12-kick.html"))
                .contains("<strong>Ziel</strong>: Schieße den Ball")
                .contains("<h2 id=\"beginnen\">", "kick Kick.java --language de", "120 Minuten", "12 Sekunden")
                .contains("<a href=\"../12-kick.html\">");
    }

    @Test
    void pagesLoadNothingFromOutsideAndHaveNoScriptInside() throws IOException {
        build(projectRoot());

        for (Path page : files(".html")) {
            assertThat(Files.readString(page))
                    .doesNotContainPattern("src=\"https?:")
                    .doesNotContainPattern("<script(?! src=)")
                    .doesNotContainPattern("<link[^>]*href=\"https?:")
                    .doesNotContain("{{");
        }
    }

    private void build(Path root) throws IOException {
        new SiteBuilder(root, "1.2.3").build(site);
    }

    private void page(String name, String text) throws IOException {
        Path file = project.resolve(name);
        Files.createDirectories(Objects.requireNonNull(file.getParent()));
        Files.writeString(file, text);
    }

    private String read(String address) throws IOException {
        return Files.readString(site.resolve(address));
    }

    private List<String> missingFiles(Path page) throws IOException {
        return references(Files.readString(page))
                .filter(address -> !Files.isRegularFile(page.resolveSibling(address)))
                .toList();
    }

    private static Stream<String> references(String html) {
        return REFERENCE
                .matcher(html)
                .results()
                .map((MatchResult match) -> match.group(1))
                .filter(address -> !address.contains("://") && !address.startsWith("#"))
                .map(address -> address.replaceFirst("#.*", ""));
    }

    private String nameOf(Path page) {
        return site.relativize(page.normalize()).toString().replace('\\', '/');
    }

    private List<Path> files(String ending) throws IOException {
        try (Stream<Path> files = Files.walk(site)) {
            return files.filter(file -> file.toString().endsWith(ending))
                    .sorted()
                    .toList();
        }
    }

    private static Path projectRoot() {
        return Stream.iterate(Path.of("").toAbsolutePath(), Objects::nonNull, Path::getParent)
                .filter(folder -> Arrays.stream(new String[] {"mvnw", "docs"})
                        .allMatch(name -> Files.exists(folder.resolve(name))))
                .findFirst()
                .orElseThrow();
    }
}
