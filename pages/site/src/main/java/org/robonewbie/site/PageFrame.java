package org.robonewbie.site;

import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** HTML template around each page: name, version, search, table of contents, and links to the previous and the next page. */
final class PageFrame {

    private static final String START = "index.html";
    private static final Pattern CHAPTER = Pattern.compile("(?s)(<h2 .*?)(?=<h2 |$)");
    private static final Pattern WORKSHEET = Pattern.compile("exercises/(de/)?\\d.*");

    private final String template;
    private final String version;
    private final Navigation navigation;

    /**
     * Creates the template.
     *
     * @param template HTML with placeholders such as {@code {{title}}}
     * @param version version of the project
     * @param navigation table of contents
     */
    PageFrame(String template, String version, Navigation navigation) {
        this.template = template;
        this.version = version;
        this.navigation = navigation;
    }

    /** Renders an article. */
    String around(Article article) {
        Optional<Navigation.Chapter> chapter = navigation.chapterOf(article);
        return fill(
                article.address(), article.title(), chapter, onThisPage(article), neighbours(article), html(article));
    }

    /** Renders any other page. */
    String around(String address, String title, String html) {
        return fill(address, title, Optional.empty(), "", "", html);
    }

    /** Escapes text for HTML. */
    static String escape(String text) {
        return text.replace("&", "&amp;")
                .replace("<", "&lt;")
                .replace(">", "&gt;")
                .replace("\"", "&quot;");
    }

    /** Returns the HTML of an article; on the start page, the chapters are blocks side by side. */
    private static String html(Article article) {
        return article.address().equals(START)
                ? CHAPTER.matcher(article.html()).replaceAll("<section>$1</section>\n")
                : article.html();
    }

    private String fill(
            String address,
            String title,
            Optional<Navigation.Chapter> chapter,
            String contents,
            String neighbours,
            String html) {
        String top = Addresses.relative(address, START).replaceFirst("index\\.html$", "");
        return template.replace("{{title}}", escape(title))
                .replace("{{language}}", Article.language(address))
                .replace("{{kind}}", kind(address))
                .replace(
                        "{{part}}",
                        escape(chapter.map(Navigation.Chapter::title).orElse("")))
                .replace("{{version}}", escape(version))
                .replace("{{top}}", top)
                .replace("{{navigation}}", list(address, chapter))
                .replace("{{contents}}", contents)
                .replace("{{neighbours}}", neighbours)
                .replace("{{text}}", html);
    }

    private static String kind(String address) {
        if (WORKSHEET.matcher(address).matches()) {
            return " class=\"worksheet\"";
        }
        return address.equals(START) ? " class=\"front\"" : "";
    }

    /** Lists the pages of a chapter and links to the start page; without a chapter, lists the pages of all chapters. */
    private String list(String address, Optional<Navigation.Chapter> only) {
        return only.map(chapter ->
                        list(address, chapter) + "<p>" + link(address, START, "All documentation", "") + "</p>\n")
                .orElseGet(() -> navigation.chapters().stream()
                        .map(chapter -> list(address, chapter))
                        .collect(Collectors.joining()));
    }

    private static String list(String address, Navigation.Chapter chapter) {
        return "<h2>" + link(address, chapter.address(), chapter.title(), current(address, chapter.address()))
                + "</h2>\n<ul>\n"
                + chapter.entries().stream().map(entry -> entry(address, entry)).collect(Collectors.joining())
                + "</ul>\n";
    }

    private static String entry(String address, Navigation.Entry entry) {
        boolean isHere = Stream.concat(Stream.of(entry.article()), entry.below().stream())
                .anyMatch(article -> article.address().equals(address));
        String below = isHere && !entry.below().isEmpty()
                ? "<ul>"
                        + entry.below().stream()
                                .map(article -> item(address, article, ""))
                                .collect(Collectors.joining())
                        + "</ul>"
                : "";
        return item(address, entry.article(), below);
    }

    private static String item(String address, Article article, String below) {
        return "<li>" + link(address, article.address(), article.title(), current(address, article.address())) + below
                + "</li>\n";
    }

    private static String current(String address, String target) {
        return target.equals(address) ? " aria-current=\"page\"" : "";
    }

    private static String link(String address, String target, String title, String attributes) {
        return "<a href=\"" + Addresses.relative(address, target) + "\"" + attributes + ">" + escape(title) + "</a>";
    }

    private static String onThisPage(Article article) {
        List<Article.Section> sections = article.sections().stream()
                .filter(section -> section.level() == 2)
                .toList();
        String heading = article.language().equals("de") ? "Auf dieser Seite" : "On this page";
        return sections.size() < 2
                ? ""
                : sections.stream()
                        .map(section ->
                                "<li><a href=\"#" + section.anchor() + "\">" + escape(section.title()) + "</a></li>")
                        .collect(Collectors.joining("\n", "<h2>" + heading + "</h2>\n<ul>\n", "\n</ul>"));
    }

    private String neighbours(Article article) {
        String before = navigation
                .neighbour(article, -1)
                .map(other -> "<span>← " + link(article.address(), other.address(), other.title(), " rel=\"prev\"")
                        + "</span>")
                .orElse("<span></span>");
        String after = navigation
                .neighbour(article, 1)
                .map(other -> "<span>" + link(article.address(), other.address(), other.title(), " rel=\"next\"")
                        + " →</span>")
                .orElse("");
        return before + after;
    }
}
