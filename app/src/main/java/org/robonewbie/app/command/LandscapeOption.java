package org.robonewbie.app.command;

import org.robonewbie.programs.CalledWronglyException;
import org.robonewbie.simulator.landscape.Landscape;
import picocli.CommandLine.Option;

/** The option with which commands that start a simulator choose what stands on the pitch. */
final class LandscapeOption {

    @Option(
            names = "--scene",
            paramLabel = "NAME",
            description = "What stands on the pitch: soccer (nothing), obstacles, slope or box. Usual: soccer.")
    private String name = Landscape.SOCCER.name();

    /** Returns what the user has named; refuses names that do not exist. */
    Landscape landscape() {
        try {
            return Landscape.named(name);
        } catch (IllegalArgumentException unknown) {
            throw new CalledWronglyException(String.valueOf(unknown.getMessage()));
        }
    }
}
