package org.robonewbie.app.command;

import org.robonewbie.programs.CalledWronglyException;
import org.robonewbie.simulator.landscape.Landscape;
import picocli.CommandLine.Option;

/** Option {@code --scene}, which selects the obstacles on the pitch. */
final class LandscapeOption {

    @Option(
            names = "--scene",
            paramLabel = "NAME",
            description = "Objects on the pitch: soccer (none), obstacles, slope or box (default: soccer).")
    private String name = Landscape.SOCCER.name();

    Landscape landscape() {
        try {
            return Landscape.named(name);
        } catch (IllegalArgumentException unknown) {
            throw new CalledWronglyException(String.valueOf(unknown.getMessage()));
        }
    }
}
