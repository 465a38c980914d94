package org.robonewbie.app.command;

import java.util.Iterator;
import org.robonewbie.programs.CalledWronglyException;
import org.robonewbie.simulator.landscape.Landscape;
import picocli.CommandLine.Option;

/** Option {@code --scene}, which selects the obstacles on the pitch. */
final class LandscapeOption {

    @Option(
            names = "--scene",
            paramLabel = "NAME",
            completionCandidates = Scenes.class,
            description = "Objects on the pitch (default: soccer): ${COMPLETION-CANDIDATES}.")
    private String name = Landscape.SOCCER.name();

    /** Scene names, each with a description, for the help text. */
    static final class Scenes implements Iterable<String> {
        @Override
        public Iterator<String> iterator() {
            return Landscape.ALL.stream()
                    .map(scene -> scene.name() + " (" + scene.description() + ")")
                    .iterator();
        }
    }

    Landscape landscape() {
        try {
            return Landscape.named(name);
        } catch (IllegalArgumentException unknown) {
            throw new CalledWronglyException(String.valueOf(unknown.getMessage()));
        }
    }
}
