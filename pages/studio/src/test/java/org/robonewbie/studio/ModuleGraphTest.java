package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class ModuleGraphTest {

    private static final String START = """
            /** @typedef {import('./types.js').Type} Type */
            await import('./main.js');
            """;

    private static final String MAIN = """
            import * as three from 'three';
            import {
              one,
              two,
            } from './parts/one.js';
            import './parts/two.js';
            const later = await import('./later.js');
            """;

    private static final String ONE = """
            export { two } from './two.js';
            import { other } from '../other.js';
            """;

    private static final Map<String, String> SCRIPTS = Map.of(
            "start.js", START,
            "main.js", MAIN,
            "parts/one.js", ONE,
            "parts/two.js", "import { one } from './one.js';");

    private final ModuleGraph graph = new ModuleGraph(name -> Optional.ofNullable(SCRIPTS.get(name)));

    @Test
    void findsTransitiveImportsInBreadthFirstOrder() {
        assertThat(graph.scriptsOf("start.js")).containsExactly("main.js", "parts/one.js", "parts/two.js", "other.js");
    }

    @Test
    void pageNamesThemBeforeTheScriptThatNeedsThem() {
        assertThat(graph.withPreloads("<head>\n    <script type=\"module\" src=\"parts/two.js\"></script></head>"))
                .isEqualTo("""
                        <head>
                            <link rel="modulepreload" href="parts/one.js">
                            <link rel="modulepreload" href="other.js">
                            <script type="module" src="parts/two.js"></script></head>""");
    }

    @Test
    void pageWithoutScriptsIsUnchanged() {
        assertThat(graph.withPreloads("<p>Hello</p>")).isEqualTo("<p>Hello</p>");
    }
}
