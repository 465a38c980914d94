package org.robonewbie.site;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.commonmark.ext.gfm.tables.TablesExtension;
import org.commonmark.node.AbstractVisitor;
import org.commonmark.node.Heading;
import org.commonmark.node.HtmlBlock;
import org.commonmark.node.Node;
import org.commonmark.parser.Parser;
import org.commonmark.renderer.html.HtmlRenderer;
import org.commonmark.renderer.text.TextContentRenderer;

/** A parsed Markdown page. Its headings have the same anchors as on code hosts, so links work there and on the site. */
final class Article {

    private static final List<TablesExtension> TABLES = List.of((TablesExtension) TablesExtension.create());
    private static final Parser PARSER = Parser.builder().extensions(TABLES).build();
    private static final TextContentRenderer TEXT =
            TextContentRenderer.builder().extensions(TABLES).build();

    private final Path source;
    private final String address;
    private final Node document;
    private final Map<Heading, Section> sections;

    private Article(Path source, String address, Node document, Map<Heading, Section> sections) {
        this.source = source;
        this.address = address;
        this.document = document;
        this.sections = sections;
    }

    /**
     * A section under a heading.
     *
     * @param level level of the heading, 1 for the title
     * @param anchor its anchor
     * @param title text of the heading
     * @param text plain text up to the next heading, without comments
     */
    record Section(int level, String anchor, String title, String text) {}

    static Article read(Path source, String address) throws IOException {
        Node document = PARSER.parse(WorksheetTemplate.fill(source, Files.readString(source)));
        return new Article(source, address, document, sections(document));
    }

    /** Reads one chapter of a page as a separate page, with the chapter's heading as the title. */
    static Article readChapter(Path source, String title, String address) throws IOException {
        Node document = PARSER.parse(Files.readString(source));
        boolean isInside = false;
        for (Node node = document.getFirstChild(), next; node != null; node = next) {
            next = node.getNext();
            if (node instanceof Heading heading && heading.getLevel() <= 2) {
                isInside = text(heading).equals(title);
                heading.setLevel(1);
            }
            if (!isInside) {
                node.unlink();
            }
        }
        return new Article(source, address, document, sections(document));
    }

    Path source() {
        return source;
    }

    String address() {
        return address;
    }

    Node document() {
        return document;
    }

    /** Returns the language code, such as {@code en}. */
    String language() {
        return language(address);
    }

    /** Returns the language code of the page at an address. */
    static String language(String address) {
        return address.contains("/de/") ? "de" : "en";
    }

    /** Returns the text of the first heading. */
    String title() {
        return sections().stream().findFirst().map(Section::title).orElse(address);
    }

    List<Section> sections() {
        List<Section> ordered = new ArrayList<>();
        document.accept(new AbstractVisitor() {
            @Override
            public void visit(Heading heading) {
                Optional.ofNullable(sections.get(heading)).ifPresent(ordered::add);
            }
        });
        return ordered;
    }

    boolean hasAnchor(String anchor) {
        return sections.values().stream().anyMatch(section -> section.anchor().equals(anchor));
    }

    /**
     * Renders the page as HTML with its current links. Empty header cells of tables become data cells, for screen readers; code blocks are
     * focusable, so that long lines can be scrolled with the arrow keys.
     */
    String html() {
        return HtmlRenderer.builder()
                .extensions(TABLES)
                .attributeProviderFactory(context -> (node, tag, attributes) -> {
                    if (node instanceof Heading heading && sections.containsKey(heading)) {
                        attributes.put("id", sections.get(heading).anchor());
                    }
                    if (tag.equals("pre")) {
                        attributes.put("tabindex", "0");
                    }
                })
                .build()
                .render(document)
                .replace("<th></th>", "<td></td>");
    }

    private static Map<Heading, Section> sections(Node document) {
        Map<Heading, Section> sections = new HashMap<>();
        Map<String, Integer> used = new HashMap<>();
        for (Node node = document.getFirstChild(); node != null; node = node.getNext()) {
            if (node instanceof Heading heading) {
                String title = text(heading);
                sections.put(heading, new Section(heading.getLevel(), anchor(title, used), title, textBelow(heading)));
            }
        }
        return sections;
    }

    private static String textBelow(Heading heading) {
        StringBuilder text = new StringBuilder();
        for (Node node = heading.getNext(); node != null && !(node instanceof Heading); node = node.getNext()) {
            if (!(node instanceof HtmlBlock)) {
                text.append(text(node)).append(' ');
            }
        }
        return text.toString().replaceAll("\\s+", " ").trim();
    }

    /** Returns the plain text of a node. */
    static String text(Node node) {
        return TEXT.render(node).trim();
    }

    private static String anchor(String title, Map<String, Integer> used) {
        String plain = title.toLowerCase(Locale.ROOT)
                .replaceAll("[^\\p{L}\\p{N} _-]", "")
                .replace(' ', '-');
        int before = used.merge(plain, 1, Integer::sum) - 1;
        return before == 0 ? plain : plain + "-" + before;
    }
}
