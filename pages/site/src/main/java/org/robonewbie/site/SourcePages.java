package org.robonewbie.site;

import java.io.IOException;
import java.nio.charset.CharacterCodingException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Renders project files that pages refer to, such as example sources, so that the site is self-contained.
 */
final class SourcePages {

    private final Addresses addresses;

    /**
     * Creates the renderer.
     *
     * @param addresses addresses of all files
     */
    SourcePages(Addresses addresses) {
        this.addresses = addresses;
    }

    /**
     * A page that shows a file.
     *
     * @param title title of the page
     * @param html its HTML
     */
    record Content(String title, String html) {}

    /** Renders a file, or a folder and all text files in it. */
    Map<String, Content> of(Path target) throws IOException {
        Map<String, Content> pages = new TreeMap<>();
        if (!Files.isDirectory(target)) {
            show(target).ifPresent(content -> pages.put(addresses.of(target), content));
            return pages;
        }
        List<Path> files;
        try (Stream<Path> below = Files.walk(target)) {
            files = below.filter(Files::isRegularFile).sorted().toList();
        }
        for (Path file : files) {
            show(file).ifPresent(content -> pages.put(addresses.of(file), content));
        }
        pages.put(addresses.of(target), list(target, files));
        return pages;
    }

    private Content list(Path folder, List<Path> files) {
        String from = addresses.of(folder);
        String items = files.stream()
                .map(file -> "<li><a href=\"" + Addresses.relative(from, addresses.of(file)) + "\">"
                        + PageFrame.escape(folder.relativize(file).toString()) + "</a></li>")
                .collect(Collectors.joining("\n"));
        String name = addresses.name(folder);
        return new Content(name, "<h1>" + PageFrame.escape(name) + "</h1>\n<ul>\n" + items + "\n</ul>\n");
    }

    private Optional<Content> show(Path file) throws IOException {
        try {
            String name = addresses.name(file);
            String html = "<h1>" + PageFrame.escape(name) + "</h1>\n<pre tabindex=\"0\"><code>"
                    + PageFrame.escape(Files.readString(file)) + "</code></pre>\n";
            return Optional.of(new Content(name, html));
        } catch (CharacterCodingException noText) {
            return Optional.empty();
        }
    }
}
