package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class ModuleGraphTest {

    private final ModuleGraph graph = new ModuleGraph(name -> Optional.ofNullable(Map.of(
                    "start.js",
                    "/** @typedef {import('./types.js').Type} Type */\nawait import('./main.js');\n",
                    "main.js",
                    "import * as three from 'three';\nimport {\n  one,\n  two,\n} from './parts/one.js';\n"
                            + "import './parts/two.js';\nconst later = await import('./later.js');\n",
                    "parts/one.js",
                    "export { two } from './two.js';\nimport { other } from '../other.js';\n",
                    "parts/two.js",
                    "import { one } from './one.js';\n")
            .get(name)));

    @Test
    void allScriptsAreFoundLayerByLayerAndLaterOnesAreLeftOut() {
        assertThat(graph.scriptsOf("start.js"))
                .containsExactly("main.js", "parts/one.js", "parts/two.js", "other.js");
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
    void pageWithoutScriptsStaysAsItIs() {
        assertThat(graph.withPreloads("<p>Hello</p>")).isEqualTo("<p>Hello</p>");
    }
}
