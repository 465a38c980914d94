package org.robonewbie.studio;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Objects;
import java.util.stream.Stream;
import org.junit.jupiter.api.Assumptions;

/** Tools that {@code npm install} installs in the folder of the studio. */
final class NodeTool {

    private NodeTool() {}

    /** Returns the path of a tool's script; skips the test if it is missing. */
    static Path require(String script) {
        Path path = project().resolve("pages/studio/node_modules").resolve(script);
        boolean isRequired = System.getenv("ROBONEWBIE_REQUIRE_TOOLS") != null;
        if (!Files.exists(path) && !isRequired) {
            System.out.println("SKIPPED: " + script + " is not installed; run npm install in pages/studio first.");
        }
        Assumptions.assumeTrue(isRequired || Files.exists(path), script + " is not installed");
        return path;
    }

    /** Returns the root of the project, above the folder of the module in which Maven runs a test. */
    static Path project() {
        return Stream.iterate(Path.of("").toAbsolutePath(), Objects::nonNull, Path::getParent)
                .filter(folder -> Files.exists(folder.resolve("mvnw")))
                .findFirst()
                .orElseThrow();
    }
}
