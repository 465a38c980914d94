package org.robonewbie.competition;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.robonewbie.competition.contest.Conditions;
import org.robonewbie.competition.contest.Contests;
import org.robonewbie.competition.contest.Table;
import org.robonewbie.competition.programs.CallsExit;
import org.robonewbie.competition.programs.Crashes;
import org.robonewbie.competition.programs.EatsMemory;
import org.robonewbie.competition.programs.Hangs;
import org.robonewbie.competition.programs.IsKilled;
import org.robonewbie.competition.team.TeamEntry;
import org.robonewbie.competition.team.TeamList;
import org.robonewbie.competition.trial.Spectators;
import org.robonewbie.programs.process.Limits;
import org.robonewbie.programs.process.Sandbox;

/** A scoring contest of ten teams: examples with different seeds, and five programs that behave badly. */
final class TenTeams {

    private static final String EXAMPLES = "org.robonewbie.examples.";
    private static final double SECONDS = 6;
    private static final Limits LIMITS = new Limits(256, 120, 8, 120, 600);

    private TenTeams() {}

    /** Holds the contest in the folder that is the argument. */
    public static void main(String[] args) throws IOException, InterruptedException {
        hold(Path.of(args[0]), System.out);
    }

    static Table hold(Path results, PrintStream out) throws IOException, InterruptedException {
        List<TeamEntry> teams = TeamList.parse(lines());
        Map<String, Long> seeds = new TreeMap<>();
        teams.forEach(team -> team.seed().ifPresent(seed -> seeds.put(team.name(), seed)));
        CompetitionSettings settings = new CompetitionSettings(
                1, results, Path.of(""), Map.of(), 2, LIMITS, Sandbox.none("not wanted"), Spectators.NOBODY);
        return new Competition(Contests.scoring(new Conditions(1, false, seeds), SECONDS), teams, settings, out).hold();
    }

    private static List<String> lines() {
        List<String> lines = new ArrayList<>();
        for (int i = 1; i <= 3; i++) {
            lines.add("Better" + i + "=" + EXAMPLES + "Agent_BetterSoccer");
            lines.add("Better" + i + ".seed=" + i);
        }
        for (int i = 1; i <= 2; i++) {
            lines.add("Simple" + i + "=" + EXAMPLES + "Agent_SimpleWalkToBall");
            lines.add("Simple" + i + ".seed=" + i);
        }
        lines.add("Crasher=" + Crashes.class.getName());
        lines.add("Killed=" + IsKilled.class.getName());
        lines.add("Hanger=" + Hangs.class.getName());
        lines.add("Eater=" + EatsMemory.class.getName());
        lines.add("Leaver=" + CallsExit.class.getName());
        return lines;
    }
}
