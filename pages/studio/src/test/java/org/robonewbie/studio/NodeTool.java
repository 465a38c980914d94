package org.robonewbie.studio;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Assumptions;

/** Tools that {@code npm install} installs in the folder of the studio. */
final class NodeTool {

    private NodeTool() {}

    /** Returns the path of a tool's script, relative to the folder of any module; skips the test if it is missing. */
    static Path require(String script) {
        Path path = Path.of("..", "studio", "node_modules").resolve(script);
        boolean isRequired = System.getenv("ROBONEWBIE_REQUIRE_TOOLS") != null;
        if (!Files.exists(path) && !isRequired) {
            System.out.println("SKIPPED: " + script + " is not installed; run npm install in studio first.");
        }
        Assumptions.assumeTrue(isRequired || Files.exists(path), script + " is not installed");
        return path;
    }
}
