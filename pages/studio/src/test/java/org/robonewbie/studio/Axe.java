package org.robonewbie.studio;

import com.google.gson.JsonElement;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.util.List;
import java.util.stream.StreamSupport;

/** axe-core, which looks for what keeps people with disabilities from using a page; {@code npm install} brings it. */
final class Axe {

    /** What is wrong and where; one line for each place. */
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

    /** Lists the violations in the page that is open. */
    List<String> violations(Chromium browser) {
        browser.evaluate("window.axe || (() => {" + script + "})(); true");
        return StreamSupport.stream(browser.evaluate(LOOK).getAsJsonArray().spliterator(), false)
                .map(JsonElement::getAsString)
                .toList();
    }
}
