package org.robonewbie.site;

import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/** HTML template around each page: name, version, search, table of contents, and links to the previous and the next page. */
final class PageFrame {

    private static final String START = "index.html";
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
        return fill(article.address(), article.title(), article.html(), onThisPage(article), neighbours(article));
    }

    /** Renders any other page. */
    String around(String address, String title, String html) {
        return fill(address, title, html, "", "");
    }

    /** Escapes a text for HTML. */
    static String escape(String text) {
        return text.replace("&", "&amp;")
                .replace("<", "&lt;")
                .replace(">", "&gt;")
                .replace("\"", "&quot;");
    }

    private String fill(String address, String title, String html, String contents, String neighbours) {
        String top = Addresses.relative(address, START).replaceFirst("index\\.html$", "");
        return template.replace("{{title}}", escape(title))
                .replace("{{language}}", address.contains("/de/") ? "de" : "en")
                .replace("{{kind}}", WORKSHEET.matcher(address).matches() ? " class=\"worksheet\"" : "")
                .replace("{{version}}", escape(version))
                .replace("{{top}}", top)
                .replace("{{navigation}}", list(address))
                .replace("{{contents}}", contents)
                .replace("{{neighbours}}", neighbours)
                .replace("{{text}}", html);
    }

    private String list(String address) {
        return navigation.chapters().stream()
                .map(chapter -> "<h2>" + escape(chapter.title()) + "</h2>\n<ul>\n"
                        + chapter.entries().stream()
                                .map(entry -> entry(address, entry))
                                .collect(Collectors.joining())
                        + "</ul>\n")
                .collect(Collectors.joining());
    }

    private static String entry(String address, Navigation.Entry entry) {
        String folder = entry.article().address().replaceFirst("index\\.html$", "");
        boolean open = !entry.below().isEmpty() && address.startsWith(folder);
        String below = open
                ? "<ul>"
                        + entry.below().stream()
                                .map(article -> item(address, article, ""))
                                .collect(Collectors.joining())
                        + "</ul>"
                : "";
        return item(address, entry.article(), below);
    }

    private static String item(String address, Article article, String below) {
        return "<li>" + link(address, article, article.address().equals(address) ? " aria-current=\"page\"" : "")
                + below + "</li>\n";
    }

    private static String link(String address, Article article, String attributes) {
        return "<a href=\"" + Addresses.relative(address, article.address()) + "\"" + attributes + ">"
                + escape(article.title()) + "</a>";
    }

    private static String onThisPage(Article article) {
        List<Article.Section> sections = article.sections().stream()
                .filter(section -> section.level() == 2)
                .toList();
        return sections.size() < 2
                ? ""
                : sections.stream()
                        .map(section ->
                                "<li><a href=\"#" + section.anchor() + "\">" + escape(section.title()) + "</a></li>")
                        .collect(Collectors.joining("\n", "<h2>On this page</h2>\n<ul>\n", "\n</ul>"));
    }

    private String neighbours(Article article) {
        String before = navigation
                .neighbour(article, -1)
                .map(other -> "<span>← " + link(article.address(), other, " rel=\"prev\"") + "</span>")
                .orElse("<span></span>");
        String after = navigation
                .neighbour(article, 1)
                .map(other -> "<span>" + link(article.address(), other, " rel=\"next\"") + " →</span>")
                .orElse("");
        return before + after;
    }
}
