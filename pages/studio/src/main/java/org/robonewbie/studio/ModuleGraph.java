package org.robonewbie.studio;

import java.net.URI;
import java.util.LinkedHashSet;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/**
 * Adds {@code modulepreload} links for all scripts of a page. Without them, a browser discovers imports only after it has parsed the
 * importing script, one layer per round trip.
 */
public final class ModuleGraph {

    private static final Pattern START = Pattern.compile("<script type=\"module\" src=\"([^\"]+)\"></script>");
    private static final Pattern IMPORT = Pattern.compile(
            "^(?:(?:import|export)\\s(?:[^;']*?from\\s)?|await import\\()'(\\.{1,2}/[^']+)'", Pattern.MULTILINE);

    private final Function<String, Optional<String>> files;

    /**
     * Creates a graph.
     *
     * @param files returns the text of the script with a given path
     */
    public ModuleGraph(Function<String, Optional<String>> files) {
        this.files = files;
    }

    /**
     * Inserts the links before the script element that needs them.
     *
     * @param page HTML of the page
     * @return the HTML with one link per script
     */
    public String withPreloads(String page) {
        Matcher start = START.matcher(page);
        if (!start.find()) {
            return page;
        }
        String links = scriptsOf(start.group(1)).stream()
                .map(script -> "<link rel=\"modulepreload\" href=\"" + script + "\">\n    ")
                .collect(Collectors.joining());
        return page.substring(0, start.start()) + links + page.substring(start.start());
    }

    /** Returns the transitive imports of a script in breadth-first order, without the script itself. */
    Set<String> scriptsOf(String script) {
        Set<String> found = new LinkedHashSet<>();
        Set<String> layer = Set.of(script);
        while (!layer.isEmpty()) {
            Set<String> next = new LinkedHashSet<>();
            layer.forEach(each -> next.addAll(importsOf(each)));
            next.removeAll(found);
            next.remove(script);
            found.addAll(next);
            layer = next;
        }
        return found;
    }

    private Set<String> importsOf(String script) {
        URI place = URI.create(script);
        return files.apply(script).stream()
                .flatMap(text -> IMPORT.matcher(text).results())
                .map(found -> place.resolve(found.group(1)).toString())
                .collect(Collectors.toCollection(LinkedHashSet::new));
    }
}
