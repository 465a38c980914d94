package org.robonewbie.competition;

import java.nio.file.Path;
import java.util.Map;
import org.robonewbie.competition.trial.Spectators;
import org.robonewbie.programs.process.Limits;
import org.robonewbie.programs.process.Sandbox;

/**
 * How a contest is held.
 *
 * @param seed start of all random numbers, as the table tells it
 * @param results folder for results
 * @param teamsFolder where the paths of teams begin
 * @param examples classes that are known by a short name
 * @param parallelTrials how many trials run at the same time
 * @param limits what programs may use
 * @param sandbox what is around the programs
 * @param spectators who watches the trials live
 */
public record CompetitionSettings(
        long seed,
        Path results,
        Path teamsFolder,
        Map<String, String> examples,
        int parallelTrials,
        Limits limits,
        Sandbox sandbox,
        Spectators spectators) {

    /** Makes the map unmodifiable. */
    public CompetitionSettings {
        examples = Map.copyOf(examples);
    }
}
