package org.robonewbie.site;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;

/**
 * Maps project files to addresses on the site. The folder {@code docs} is the root of the site, {@code README.md} is the first page of its
 * folder, and addresses consist of lower-case letters, digits and hyphens.
 */
final class Addresses {

    private static final String DOCS = "docs/";

    private final Path root;

    /**
     * Creates the mapping.
     *
     * @param root the folder of the project
     */
    Addresses(Path root) {
        this.root = root;
    }

    /** Returns the address of a page, a picture, an API page, or a page that shows a source file or folder. */
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

    /** Returns the path of a file relative to the project, separated by forward slashes. */
    String name(Path file) {
        return root.relativize(file).toString().replace('\\', '/');
    }

    /**
     * Returns the relative link between two pages, such as {@code ../c.html} from {@code a/b.html} to {@code c.html}.
     */
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
