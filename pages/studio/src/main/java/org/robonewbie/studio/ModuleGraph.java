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
 * Lists in the page itself which scripts it will need. Otherwise a browser discovers a script's imports only after reading the
 * script, and requests one layer after another.
 */
public final class ModuleGraph {

    private static final Pattern START = Pattern.compile("<script type=\"module\" src=\"([^\"]+)\"></script>");
    private static final Pattern IMPORT = Pattern.compile(
            "^(?:(?:import|export)\\s(?:[^;']*?from\\s)?|await import\\()'(\\.{1,2}/[^']+)'", Pattern.MULTILINE);

    private final Function<String, Optional<String>> files;

    /**
     * A graph of scripts.
     *
     * @param files gives the text of a script by its path
     */
    public ModuleGraph(Function<String, Optional<String>> files) {
        this.files = files;
    }

    /**
     * Adds the links to a page, before the script that needs them.
     *
     * @param page its HTML
     * @return the page with a link for each script
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

    /** All scripts that a script needs from its start on, itself not counted; those that it needs directly come first. */
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
