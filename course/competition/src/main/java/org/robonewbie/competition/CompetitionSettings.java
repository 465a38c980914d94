package org.robonewbie.competition;

import java.nio.file.Path;
import java.util.Map;
import org.robonewbie.competition.trial.Spectators;
import org.robonewbie.programs.process.Limits;
import org.robonewbie.programs.process.Sandbox;

/**
 * Settings of a contest.
 *
 * @param seed seed of all random numbers; printed in the table
 * @param results folder in which results are stored
 * @param teamsFolder folder to which the paths of teams are relative
 * @param examples full class names of the examples, by simple name
 * @param parallelTrials number of trials to run in parallel
 * @param limits resource limits for each program
 * @param sandbox sandbox in which the programs run
 * @param spectators live viewers
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

    /** Creates the settings. */
    public CompetitionSettings {
        examples = Map.copyOf(examples);
    }
}
