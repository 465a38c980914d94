package org.robonewbie.app;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;

/**
 * Draws the modules as SVG, each above those that its classes use. An arrow that others already imply is left out: who uses the
 * agent uses what the agent uses.
 */
final class ModulePicture {

    private static final String HOUSE = "org.robonewbie.";
    private static final int BOX_WIDTH = 104;
    private static final int BOX_HEIGHT = 34;
    private static final int COLUMN = 124;
    private static final int ROW = 84;
    private static final int MARGIN = 20;

    private final Map<String, Set<String>> uses = new TreeMap<>();
    private final List<List<String>> rows = new ArrayList<>();

    ModulePicture(JavaClasses classes) {
        classes.forEach(this::note);
        uses.keySet().forEach(this::arrange);
    }

    private void note(JavaClass type) {
        Set<String> used = uses.computeIfAbsent(module(type), name -> new TreeSet<>());
        type.getDirectDependenciesFromSelf().stream()
                .map(dependency -> dependency.getTargetClass().getBaseComponentType())
                .filter(target -> target.getPackageName().startsWith(HOUSE))
                .map(ModulePicture::module)
                .filter(name -> !name.equals(module(type)))
                .forEach(used::add);
    }

    private static String module(JavaClass type) {
        return type.getPackageName().substring(HOUSE.length()).split("\\.", 2)[0];
    }

    private void arrange(String module) {
        int floor = floor(module);
        while (rows.size() <= floor) {
            rows.add(new ArrayList<>());
        }
        rows.get(floor).add(module);
    }

    /** The ground floor uses nothing, each other stands on the highest that it uses. */
    private int floor(String module) {
        return uses(module).stream().mapToInt(used -> floor(used) + 1).max().orElse(0);
    }

    private Set<String> uses(String module) {
        return uses.getOrDefault(module, Set.of());
    }

    private boolean reaches(String from, String to) {
        return uses(from).stream().anyMatch(next -> next.equals(to) || reaches(next, to));
    }

    /** {@return the picture} */
    String svg() {
        StringBuilder svg = new StringBuilder(
                String.format(Locale.ROOT, """
                <svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 %1$d %2$d" width="%1$d" height="%2$d" \
                font-family="sans-serif" font-size="14">
                <title>The modules and what they use</title>
                <rect width="%1$d" height="%2$d" rx="8" fill="#ffffff"/>
                <marker id="tip" viewBox="0 0 8 8" refX="8" refY="4" markerWidth="8" markerHeight="8" orient="auto">\
                <path d="M0 0 8 4 0 8z" fill="#5b6b7f"/></marker>
                """, width(), 2 * MARGIN + ROW * (rows.size() - 1) + BOX_HEIGHT));
        uses.keySet()
                .forEach(module -> uses(module).stream()
                        .filter(used -> uses(module).stream().noneMatch(other -> reaches(other, used)))
                        .forEach(used -> svg.append(arrow(module, used))));
        uses.keySet().forEach(module -> svg.append(box(module)));
        return svg.append("</svg>\n").toString();
    }

    private String arrow(String from, String to) {
        return String.format(
                Locale.ROOT,
                "<line x1=\"%d\" y1=\"%d\" x2=\"%d\" y2=\"%d\" stroke=\"#5b6b7f\" stroke-width=\"1.5\" marker-end=\"url(#tip)\"/>\n",
                middle(from),
                top(from) + BOX_HEIGHT,
                middle(to),
                top(to) - 2);
    }

    private String box(String module) {
        return String.format(
                Locale.ROOT,
                "<rect x=\"%d\" y=\"%d\" width=\"%d\" height=\"%d\" rx=\"6\" fill=\"#e8f0fa\" stroke=\"#2f5d8c\"/>"
                        + "<text x=\"%d\" y=\"%d\" text-anchor=\"middle\" fill=\"#14283c\">%s</text>\n",
                middle(module) - BOX_WIDTH / 2,
                top(module),
                BOX_WIDTH,
                BOX_HEIGHT,
                middle(module),
                top(module) + 22,
                module);
    }

    private int middle(String module) {
        List<String> row = rows.get(floor(module));
        return width() / 2 + COLUMN * (2 * row.indexOf(module) - row.size() + 1) / 2;
    }

    private int top(String module) {
        return MARGIN + ROW * (rows.size() - 1 - floor(module));
    }

    private int width() {
        return 2 * MARGIN + COLUMN * rows.stream().mapToInt(List::size).max().orElse(1);
    }
}
