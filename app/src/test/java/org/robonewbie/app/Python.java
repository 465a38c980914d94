package org.robonewbie.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Assumptions;

/** Runs Python where it is installed, with the package of this project, which starts the simulator of this build. */
public record Python(Path folder) {

    /** Folder of the package. */
    public static final Path PACKAGE = Project.ROOT.resolve("research/python");

    /** Skips the test, aloud, where Python or one of the packages is missing, unless all tools are required. */
    public void skipWithout(String packages) throws Exception {
        Assumptions.assumeTrue(canRun("import " + packages), packages);
    }

    /** Returns whether Python can run these imports, and says so if it cannot. Fails instead if all tools are required. */
    public boolean canRun(String imports) throws Exception {
        boolean usable = false;
        try {
            usable = run("-c", imports).code() == 0;
        } catch (IOException noPython) {
            // Reported below.
        }
        String missing = "Python 3 is not installed or does not know what it needs: " + imports;
        if (!usable && System.getenv("ROBONEWBIE_REQUIRE_TOOLS") != null) {
            throw new AssertionError(missing + ", but ROBONEWBIE_REQUIRE_TOOLS asks for it.");
        }
        if (!usable) {
            System.out.println("SKIPPED: " + missing);
        }
        return usable;
    }

    /** Runs Python in the folder. */
    public ProcessResult run(String... arguments) throws Exception {
        Path launcher = launcher();
        try {
            ProcessBuilder builder = new ProcessBuilder("python3").directory(folder.toFile());
            builder.command().addAll(List.of(arguments));
            builder.environment().put("PYTHONPATH", PACKAGE.toString());
            builder.environment().put("ROBONEWBIE", launcher.toString());
            builder.environment().put("PYTHONDONTWRITEBYTECODE", "1");
            return ProcessResult.of(builder);
        } finally {
            Files.delete(launcher);
        }
    }

    private static Path launcher() throws IOException {
        Path launcher = Files.createTempFile("robonewbie", ".sh");
        Files.writeString(
                launcher,
                "#!/bin/sh\nexec \"" + Path.of(System.getProperty("java.home"), "bin", "java") + "\" -cp \""
                        + System.getProperty("java.class.path") + "\" org.robonewbie.app.Main \"$@\"\n");
        assertThat(launcher.toFile().setExecutable(true)).isTrue();
        return launcher;
    }
}
