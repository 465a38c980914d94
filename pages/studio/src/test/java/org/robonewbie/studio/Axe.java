package org.robonewbie.studio;

import com.google.gson.JsonElement;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.util.List;
import java.util.stream.StreamSupport;

/** axe-core, a checker for violations of accessibility rules; installed by {@code npm install}. */
final class Axe {

    /** Lists rules and elements; one line per element. */
    private static final String LOOK = """
            axe.run(document, {resultTypes: ['violations']}).then(({violations}) => violations.flatMap(({help, nodes}) =>
              nodes.map(({target, html}) => `${help}: ${target.join(' ')} ${html.slice(0, 200)}`)))""";

    private final String script;

    Axe() {
        try {
            script = Files.readString(NodeTool.require("axe-core/axe.min.js"), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Lists the violations in the open page. */
    List<String> violations(Chromium browser) {
        browser.evaluate("window.axe || (() => {" + script + "})(); true");
        return StreamSupport.stream(browser.evaluate(LOOK).getAsJsonArray().spliterator(), false)
                .map(JsonElement::getAsString)
                .toList();
    }
}
