package org.robonewbie.app.command;

import java.util.Locale;
import org.robonewbie.programs.CalledWronglyException;
import org.robonewbie.programs.process.Sandbox;
import picocli.CommandLine.Option;

/** The option {@code --fence}, which selects the sandbox for programs. */
final class FenceOption {

    private enum When {
        AUTO,
        REQUIRED,
        NONE;

        @Override
        public String toString() {
            return name().toLowerCase(Locale.ROOT);
        }
    }

    @Option(
            names = "--fence",
            paramLabel = "WHEN",
            description =
                    "Run programs in a bubblewrap sandbox (Linux): auto (if available), required, or none (default:"
                            + " ${DEFAULT-VALUE}).")
    private When fence = When.AUTO;

    /**
     * Returns the sandbox.
     *
     * @throws CalledWronglyException if a sandbox is required but not available
     */
    Sandbox sandbox() {
        if (fence == When.NONE) {
            return Sandbox.none("--fence none");
        }
        Sandbox found = Sandbox.find();
        if (fence == When.REQUIRED && !found.isUp()) {
            throw new CalledWronglyException("No sandbox is available: " + found.absence()
                    + ". Install the bubblewrap package, or omit --fence required.");
        }
        return found;
    }
}
