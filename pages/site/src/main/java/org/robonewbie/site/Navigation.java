package org.robonewbie.site;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.commonmark.node.AbstractVisitor;
import org.commonmark.node.Heading;
import org.commonmark.node.Link;
import org.commonmark.node.Node;

/**
 * Table of contents. The headings of the start page define the chapters, one for each kind of reader, and its links define their pages; the
 * other pages of a folder are nested below the folder's first page.
 */
final class Navigation {

    private final List<Chapter> chapters;

    private Navigation(List<Chapter> chapters) {
        this.chapters = chapters;
    }

    /**
     * The pages for one kind of reader.
     *
     * @param title the heading
     * @param entries the pages
     */
    record Chapter(String title, List<Entry> entries) {

        /** Returns the address of the page that shows this chapter only. */
        String address() {
            return "for/" + title.toLowerCase(Locale.ROOT).replaceAll("[^a-z0-9]+", "-") + ".html";
        }

        /** Returns the pages in reading order. */
        List<Article> order() {
            return entries.stream()
                    .flatMap(entry -> Stream.concat(Stream.of(entry.article()), entry.below().stream()))
                    .distinct()
                    .toList();
        }
    }

    /**
     * A page in a chapter.
     *
     * @param article the page
     * @param below nested pages of its folder, in reading order
     */
    record Entry(Article article, List<Article> below) {}

    /** Reads the chapters and pages from the start page, whose links must not have been translated yet. */
    static Navigation of(Article start, Map<Path, Article> articles) {
        List<Chapter> chapters = new ArrayList<>();
        for (Node node = start.document().getFirstChild(); node != null; node = node.getNext()) {
            if (node instanceof Heading heading && heading.getLevel() == 2) {
                chapters.add(new Chapter(Article.text(heading), new ArrayList<>()));
            } else if (!chapters.isEmpty()) {
                List<Entry> entries = chapters.get(chapters.size() - 1).entries();
                linked(node, start, articles)
                        .forEach(article -> entries.add(new Entry(article, below(article, articles))));
            }
        }
        return new Navigation(chapters);
    }

    List<Chapter> chapters() {
        return chapters;
    }

    /** Returns the first chapter that contains an article. */
    Optional<Chapter> chapterOf(Article article) {
        return chapters.stream()
                .filter(chapter -> chapter.address().equals(article.address())
                        || chapter.order().contains(article))
                .findFirst();
    }

    /** Returns the article that is the given number of steps away in the reading order of the chapter, for example −1 for the previous one. */
    Optional<Article> neighbour(Article article, int steps) {
        List<Article> order = chapterOf(article).map(Chapter::order).orElse(List.of());
        int index = order.indexOf(article) + steps;
        boolean exists = order.contains(article) && index >= 0 && index < order.size();
        return exists ? Optional.of(order.get(index)) : Optional.empty();
    }

    private static List<Article> linked(Node node, Article start, Map<Path, Article> articles) {
        List<Article> linked = new ArrayList<>();
        node.accept(new AbstractVisitor() {
            @Override
            public void visit(Link link) {
                Path target =
                        start.source().resolveSibling(link.getDestination()).normalize();
                Optional.ofNullable(articles.get(target)).ifPresent(linked::add);
            }
        });
        return linked;
    }

    private static List<Article> below(Article first, Map<Path, Article> articles) {
        if (!first.address().endsWith("/index.html")) {
            return List.of();
        }
        String folder = first.address().replaceFirst("index\\.html$", "");
        return articles.values().stream()
                .filter(article -> article.address().startsWith(folder) && article != first)
                .filter(article -> article.address().indexOf('/', folder.length()) < 0)
                .sorted(Comparator.comparing(Article::address))
                .toList();
    }
}
