package org.robonewbie.site;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;

/**
 * Maps files of the project to addresses of the site: the folder {@code docs} is the root of the site, a {@code README.md} is
 * the first page of its folder, and all addresses are lower-case letters, digits and hyphens.
 */
final class Addresses {

    private static final String DOCS = "docs/";

    private final Path root;

    /**
     * Looks at a project.
     *
     * @param root the folder of the project
     */
    Addresses(Path root) {
        this.root = root;
    }

    /** The address of a page, a picture, of an API page, or of a page that shows a source file or lists a folder. */
    String of(Path file) {
        String path = name(file);
        if (path.startsWith(DOCS)) {
            return path.endsWith(".md") ? page(path.substring(DOCS.length())) : plain(path.substring(DOCS.length()));
        }
        if (path.endsWith(".md")) {
            return plain(path.replaceFirst("\\.md$", ".html"));
        }
        if (ApiPages.isPackageOfApi(file)) {
            return ApiPages.addressOf(path);
        }
        return "files/" + plain(path) + (Files.isDirectory(file) ? "/index.html" : ".html");
    }

    /** The path of a file within the project, with slashes. */
    String name(Path file) {
        return root.relativize(file).toString().replace('\\', '/');
    }

    /** How one page names another: from {@code a/b.html} to {@code c.html} it is {@code ../c.html}. */
    static String relative(String from, String to) {
        Path folder = Path.of("/" + from).resolveSibling("").normalize();
        return folder.relativize(Path.of("/" + to)).toString().replace('\\', '/');
    }

    private static String page(String markdown) {
        return plain(markdown.replaceFirst("(^|/)README\\.md$", "$1index.md").replaceFirst("\\.md$", ".html"));
    }

    private static String plain(String path) {
        return path.toLowerCase(Locale.ROOT).replaceAll("[^a-z0-9./-]", "-");
    }
}
