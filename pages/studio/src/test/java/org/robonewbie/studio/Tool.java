package org.robonewbie.studio;

import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Assumptions;

/**
 * An external program that some tests need. Without it they are skipped with a message, unless the environment variable
 * ROBONEWBIE_REQUIRE_TOOLS is set.
 *
 * @param name display name
 * @param programs possible file names
 */
record Tool(String name, List<String> programs) {

    static final Tool BROWSER =
            new Tool("Chromium", List.of("chromium", "chromium-browser", "google-chrome", "chrome"));
    static final Tool FIREFOX = new Tool("Firefox", List.of("firefox-esr", "firefox"));
    static final Tool NODE = new Tool("Node.js", List.of("node", "node.exe"));

    Optional<Path> find() {
        return Arrays.stream(System.getenv("PATH").split(File.pathSeparator))
                .flatMap(folder -> programs.stream().map(program -> Path.of(folder, program)))
                .filter(Files::isExecutable)
                .findFirst();
    }

    /** Returns the program, or skips the calling test. */
    Path orSkip() {
        Optional<Path> program = find();
        if (program.isEmpty() && System.getenv("ROBONEWBIE_REQUIRE_TOOLS") != null) {
            throw new AssertionError(name + " is not installed, but ROBONEWBIE_REQUIRE_TOOLS asks for it.");
        }
        if (program.isEmpty()) {
            System.out.println("SKIPPED: " + name + " is not installed, so its tests do not run.");
        }
        Assumptions.assumeTrue(program.isPresent(), name + " is not installed");
        return program.orElseThrow();
    }
}
