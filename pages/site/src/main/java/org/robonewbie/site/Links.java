package org.robonewbie.site;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import org.commonmark.node.AbstractVisitor;
import org.commonmark.node.Image;
import org.commonmark.node.Link;

/** Translates links between files into links between pages, and collects the referenced files and the broken links. */
final class Links {

    private final Addresses addresses;
    private final Map<Path, Article> articles;
    private final TreeSet<Path> pictures = new TreeSet<>();
    private final TreeSet<Path> files = new TreeSet<>();
    private final List<String> broken = new ArrayList<>();

    /**
     * Creates the translator.
     *
     * @param addresses addresses of all files
     * @param articles all pages by source file
     */
    Links(Addresses addresses, Map<Path, Article> articles) {
        this.addresses = addresses;
        this.articles = articles;
    }

    /** Returns the pictures and ready-made HTML slides that pages refer to. */
    List<Path> pictures() {
        return List.copyOf(pictures);
    }

    /** Returns the remaining files and folders of the project that pages refer to. */
    List<Path> files() {
        return List.copyOf(files);
    }

    /** Returns one message per broken link. */
    List<String> broken() {
        return List.copyOf(broken);
    }

    void translate(Article article) {
        article.document().accept(new AbstractVisitor() {
            @Override
            public void visit(Link link) {
                link.setDestination(translated(article, link.getDestination()));
                visitChildren(link);
            }

            @Override
            public void visit(Image image) {
                image.setDestination(translated(article, image.getDestination()));
                visitChildren(image);
            }
        });
    }

    private String translated(Article from, String destination) {
        if (destination.contains("://") || destination.startsWith("mailto:")) {
            return destination;
        }
        int hash = destination.indexOf('#');
        String path = hash < 0 ? destination : destination.substring(0, hash);
        String anchor = hash < 0 ? "" : destination.substring(hash + 1);
        Path target = path.isEmpty()
                ? from.source()
                : from.source().resolveSibling(path).normalize();
        if (!Files.exists(target)) {
            broken.add(addresses.name(from.source()) + ": missing file in link " + destination);
            return destination;
        }
        if (!anchor.isEmpty() && !hasAnchor(target, anchor)) {
            broken.add(addresses.name(from.source()) + ": missing heading in link " + destination);
        }
        collect(target);
        String address = path.isEmpty() ? "" : Addresses.relative(from.address(), addresses.of(target));
        return anchor.isEmpty() ? address : address + "#" + anchor;
    }

    private boolean hasAnchor(Path target, String anchor) {
        return articles.containsKey(target) && articles.get(target).hasAnchor(anchor);
    }

    private void collect(Path target) {
        if (articles.containsKey(target) || ApiPages.isPackageOfApi(target)) {
            return;
        }
        if (target.toString().matches(".*\\.(png|svg|html|css)")) {
            pictures.add(target);
        } else {
            files.add(target);
        }
    }
}
