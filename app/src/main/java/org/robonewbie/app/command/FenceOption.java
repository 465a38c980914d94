package org.robonewbie.app.command;

import java.util.Locale;
import org.robonewbie.programs.CalledWronglyException;
import org.robonewbie.programs.process.Sandbox;
import picocli.CommandLine.Option;

/** The option {@code --fence} of the commands that judge programs. */
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
            description = "Fence programs in by bubblewrap (Linux): auto where there is one, required, or none"
                    + " (${DEFAULT-VALUE}).")
    private When fence = When.AUTO;

    /**
     * Finds the sandbox.
     *
     * @throws CalledWronglyException if it is required and there is none
     */
    Sandbox sandbox() {
        if (fence == When.NONE) {
            return Sandbox.none("--fence none");
        }
        Sandbox found = Sandbox.find();
        if (fence == When.REQUIRED && !found.isUp()) {
            throw new CalledWronglyException("Programs cannot be fenced in: " + found.absence()
                    + ". Install the package bubblewrap, or leave --fence required out.");
        }
        return found;
    }
}
