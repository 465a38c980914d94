package org.robonewbie.competition;

import java.nio.file.Path;
import java.util.Map;
import org.robonewbie.competition.trial.Spectators;
import org.robonewbie.programs.process.Limits;
import org.robonewbie.programs.process.Sandbox;

/**
 * Settings of a contest.
 *
 * @param seed seed of all random numbers, printed in the table
 * @param results folder for results
 * @param teamsFolder base folder of relative paths of teams
 * @param examples class names of the examples, by short name
 * @param parallelTrials number of trials that run in parallel
 * @param limits resource limits per program
 * @param sandbox sandbox of the programs
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
