package org.robonewbie.site;

import com.google.gson.GsonBuilder;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;
import java.util.stream.Stream;

/**
 * Builds the documentation site: all Markdown pages of the project as HTML that works offline, both from a folder and in the studio. A
 * broken link fails the build.
 */
public final class SiteBuilder {

    private static final List<String> ASSETS = List.of(
            "site.css",
            "print.css",
            "site.js",
            "search.js",
            "vendor/minisearch/minisearch.js",
            "vendor/minisearch/LICENSE");

    private final Path root;
    private final String version;
    private final Addresses addresses;

    /**
     * Creates a builder.
     *
     * @param root folder of the project, which contains {@code docs}
     * @param version version of the project, shown on each page
     */
    public SiteBuilder(Path root, String version) {
        this.root = root.toAbsolutePath().normalize();
        this.version = version;
        this.addresses = new Addresses(this.root);
    }

    /**
     * Builds the site.
     *
     * @param arguments folder of the project, folder of the site, version; a fourth argument enables the API pages
     * @throws IOException if a file cannot be read or written
     */
    public static void main(String[] arguments) throws IOException {
        Path root = Path.of(arguments[0]).toAbsolutePath().normalize();
        Path site = Path.of(arguments[1]);
        String commit = Commit.of(root);
        new SiteBuilder(root, arguments[2] + (commit.isEmpty() ? "" : " (" + commit + ")")).build(site);
        write(site, "commit.txt", commit);
        if (arguments.length > 3) {
            new ApiPages(root, arguments[2]).build(site);
        }
    }

    /**
     * Builds the site.
     *
     * @param site destination folder; existing files are overwritten
     * @throws BrokenLinksException if a link is broken
     * @throws IOException if a file cannot be read or written
     */
    public void build(Path site) throws IOException {
        Map<Path, Article> articles = articles();
        Article start = Objects.requireNonNull(articles.get(root.resolve("docs/README.md")), "docs/README.md");
        Navigation navigation = Navigation.of(start, articles);
        List<Article> pages = new ArrayList<>(articles.values());
        for (Navigation.Chapter chapter : navigation.chapters()) {
            pages.add(Article.readChapter(start.source(), chapter.title(), chapter.address()));
        }
        Links links = new Links(addresses, articles);
        pages.forEach(links::translate);
        if (!links.broken().isEmpty()) {
            throw new BrokenLinksException(links.broken());
        }
        PageFrame frame = new PageFrame(resource("page.html"), version, navigation);
        for (Article page : pages) {
            write(site, page.address(), frame.around(page));
        }
        writeFiles(site, links, frame);
        for (String asset : ASSETS) {
            write(site, asset, resource(asset));
        }
        write(site, "search-index.js", searchIndex(articles.values(), navigation));
    }

    private Map<Path, Article> articles() throws IOException {
        List<Path> files;
        try (Stream<Path> atRoot = Files.list(root);
                Stream<Path> docs = Files.walk(root.resolve("docs"))) {
            files = Stream.of(
                            atRoot,
                            docs,
                            Stream.of("research/python/README.md", "release/README.md")
                                    .map(root::resolve))
                    .flatMap(stream -> stream)
                    .filter(file -> file.toString().endsWith(".md") && Files.isRegularFile(file))
                    .sorted()
                    .toList();
        }
        Map<Path, Article> articles = new TreeMap<>();
        for (Path file : files) {
            articles.put(file, Article.read(file, addresses.of(file)));
        }
        return articles;
    }

    private void writeFiles(Path site, Links links, PageFrame frame) throws IOException {
        for (Path picture : links.pictures()) {
            Path file = site.resolve(addresses.of(picture));
            Files.createDirectories(Objects.requireNonNull(file.getParent()));
            Files.copy(picture, file, StandardCopyOption.REPLACE_EXISTING);
        }
        SourcePages sources = new SourcePages(addresses);
        for (Path target : links.files()) {
            for (Map.Entry<String, SourcePages.Content> page :
                    sources.of(target).entrySet()) {
                SourcePages.Content content = page.getValue();
                write(site, page.getKey(), frame.around(page.getKey(), content.title(), content.html()));
            }
        }
    }

    /**
     * Returns one entry per section, as a script rather than JSON because pages opened from a folder can load only
     * scripts.
     */
    private static String searchIndex(Collection<Article> articles, Navigation navigation) {
        List<Map<String, String>> sections = articles.stream()
                .flatMap(article -> article.sections().stream()
                        .map(section -> Map.of(
                                "address", article.address() + "#" + section.anchor(),
                                "page", article.title(),
                                "title", section.title(),
                                "text", section.text(),
                                "language", article.language(),
                                "part",
                                        navigation
                                                .chapterOf(article)
                                                .map(Navigation.Chapter::title)
                                                .orElse(""))))
                .map(TreeMap::new)
                .<Map<String, String>>map(entry -> entry)
                .toList();
        return "globalThis.searchIndex = " + new GsonBuilder().create().toJson(sections) + ";\n";
    }

    private static void write(Path site, String address, String text) throws IOException {
        Path file = site.resolve(address);
        Files.createDirectories(Objects.requireNonNull(file.getParent()));
        Files.writeString(file, text);
    }

    private static String resource(String name) throws IOException {
        try (InputStream stream =
                Objects.requireNonNull(SiteBuilder.class.getResourceAsStream(name), "There is no resource " + name)) {
            return new String(stream.readAllBytes(), StandardCharsets.UTF_8);
        }
    }
}
