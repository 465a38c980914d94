package org.robonewbie.competition;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robonewbie.competition.contest.ChallengeContest;
import org.robonewbie.competition.contest.Contest;
import org.robonewbie.competition.contest.ContestTrial;
import org.robonewbie.competition.contest.Ending;
import org.robonewbie.competition.contest.Entrant;
import org.robonewbie.competition.contest.JudgedContest;
import org.robonewbie.competition.contest.Table;
import org.robonewbie.competition.contest.TrialResult;
import org.robonewbie.competition.result.ResultFolder;
import org.robonewbie.competition.result.TableFiles;
import org.robonewbie.competition.team.TeamEntry;
import org.robonewbie.competition.team.TeamProgram;
import org.robonewbie.competition.team.TeamPrograms;
import org.robonewbie.competition.trial.ChallengePlayer;
import org.robonewbie.competition.trial.ContestProgress;
import org.robonewbie.competition.trial.TrialPlayer;
import org.robonewbie.competition.trial.TrialRunner;
import org.robonewbie.nao.text.PrintableText;
import org.robonewbie.programs.Fingerprint;
import org.robonewbie.programs.process.ProcessTree;
import org.robonewbie.trial.batch.BatchProgress;
import org.robonewbie.trial.batch.BatchRunner;
import org.robonewbie.trial.batch.ThreadRunner;

/**
 * Runs a contest, from the first trial to the final table. Each finished trial is saved in the result folder; running the same
 * contest again in the same folder runs only the missing trials.
 *
 * <pre>{@code
 * Table table = new Competition(contest, teams, settings, System.out).hold();
 * }</pre>
 */
public final class Competition {

    private final Contest contest;
    private final List<TeamEntry> teams;
    private final CompetitionSettings settings;
    private final PrintStream out;
    private final List<String> refused = new ArrayList<>();
    private int finished;
    private int planned;

    /**
     * Creates a competition.
     *
     * @param contest the contest
     * @param teams participating teams
     * @param settings seeds, limits and folders
     * @param out stream to which progress is printed
     */
    public Competition(Contest contest, List<TeamEntry> teams, CompetitionSettings settings, PrintStream out) {
        this.contest = contest;
        this.teams = List.copyOf(teams);
        this.settings = settings;
        this.out = out;
    }

    private TrialPlayer player(Map<String, TeamProgram> programs) {
        return contest instanceof ChallengeContest challenges
                ? new ChallengePlayer(
                        challenges.challenge(), programs, settings.limits(), settings.sandbox(), settings.spectators())
                : new TrialRunner(
                        (JudgedContest) contest,
                        programs,
                        settings.limits(),
                        settings.sandbox(),
                        settings.spectators());
    }

    /**
     * Runs the contest, resuming after an interruption.
     *
     * @return the table, which is also written to the result folder
     * @throws IOException if a file cannot be read or written, or a process cannot be started
     * @throws InterruptedException if this thread is interrupted
     */
    public Table hold() throws IOException, InterruptedException {
        try (ResultFolder folder = ResultFolder.open(settings.results());
                BatchRunner runner = new ThreadRunner(settings.parallelTrials())) {
            Map<String, TeamProgram> programs = programs(folder.file("work").resolve("programs"));
            TrialPlayer player = player(programs);
            List<ContestTrial> missing = missing(folder, programs);
            while (!missing.isEmpty()) {
                runAll(missing, folder, programs, player, runner);
                missing = missing(folder, programs);
            }
            Table table = contest.table(names(), folder);
            folder.repair().forEach(out::println);
            new TableFiles(folder, teams).write(table, settings.seed(), notes());
            return table;
        }
    }

    /** Returns notes on the isolation of the programs, to be printed with the table. */
    private List<String> notes() {
        if (settings.sandbox().isUp()) {
            return List.of(
                    "Programs ran in a sandbox (bubblewrap); each team had its own port, which no other team could"
                            + " reach.");
        }
        String connections = ProcessTree.hasConnections()
                ? "Connections to each team's port were checked for their origin."
                : "Connections to each team's port were not checked for their origin, because this system does not"
                        + " report it.";
        return List.of("Programs ran without a sandbox (" + settings.sandbox().absence() + ").", connections);
    }

    private List<String> names() {
        return teams.stream().map(TeamEntry::name).toList();
    }

    private Map<String, TeamProgram> programs(Path copies) throws IOException {
        TeamPrograms finder = new TeamPrograms(settings.teamsFolder(), copies, settings.examples(), settings.sandbox());
        List<Path> foreign = new ArrayList<>(finder.folders(teams));
        foreign.add(settings.results());
        Map<String, TeamProgram> programs = new LinkedHashMap<>();
        for (TeamEntry team : teams) {
            TeamProgram program = finder.find(team, foreign);
            programs.put(team.name(), program);
            if (program instanceof TeamProgram.Broken broken) {
                tell(team, broken);
            }
        }
        return programs;
    }

    private void tell(TeamEntry team, TeamProgram.Broken broken) {
        boolean isRefused = broken.ending() == Ending.REFUSED;
        out.println(
                "Team " + team.name() + (isRefused ? " was rejected" : " does not compile") + " and loses its trials:");
        broken.complaint().strip().lines().map(PrintableText::of).forEach(out::println);
        if (isRefused) {
            refused.add(team.name());
        }
    }

    /** {@return the teams whose files were refused; all other teams played. Call this after {@link #hold}} */
    public List<String> refusedTeams() {
        return List.copyOf(refused);
    }

    private List<ContestTrial> missing(ResultFolder folder, Map<String, TeamProgram> programs) throws IOException {
        List<ContestTrial> missing = new ArrayList<>();
        List<ContestTrial> before;
        List<ContestTrial> all = List.of();
        do {
            before = all;
            all = contest.trials(names(), folder);
            missing.clear();
            for (ContestTrial trial : all) {
                if (!folder.load(trial.id(), circumstances(trial, programs))) {
                    missing.add(trial);
                }
            }
        } while (all.size() > before.size());
        planned = all.size();
        finished = all.size() - missing.size();
        return missing;
    }

    private void runAll(
            List<ContestTrial> missing,
            ResultFolder folder,
            Map<String, TeamProgram> programs,
            TrialPlayer player,
            BatchRunner runner)
            throws IOException {
        if (finished > 0) {
            out.println(finished + " of " + planned + " trials are already finished; their results are kept.");
        }
        showProgress(folder, Optional.empty());
        try (BatchProgress progress = BatchProgress.of("trials", planned, finished)) {
            runner.run(
                    missing,
                    trial -> {
                        TrialResult result = player.run(trial, folder.filesOf(trial));
                        folder.save(result, circumstances(trial, programs));
                        return result;
                    },
                    (trial, result) -> {
                        finished++;
                        String line = String.format("[%d/%d] %s: %s", finished, planned, result.id(), result.inWords());
                        progress.print(out::println, line);
                        progress.advance(false);
                        showProgress(folder, Optional.of(result));
                    });
        } catch (IOException | RuntimeException failed) {
            throw new IOException("A trial failed: " + failed, failed);
        }
    }

    private void showProgress(ResultFolder folder, Optional<TrialResult> last) {
        if (!settings.spectators().isNobody()) {
            Table table = contest.table(names(), folder);
            settings.spectators().stands(new ContestProgress(finished, planned, table, last));
        }
    }

    /** Returns a checksum of everything on which a result depends: the trial, the programs and the limits. */
    private String circumstances(ContestTrial trial, Map<String, TeamProgram> programs) {
        Fingerprint all = new Fingerprint()
                .add(trial.id() + " " + trial.seed() + " " + trial.seconds() + " " + trial.kickOff()
                        + (trial.ownPlaces() ? " own places" : ""))
                .add(trial.entrants().toString())
                .add(trial.ball().toString())
                .add(trial.parameters().assignments().toString())
                .add(settings.limits().toString())
                .add(settings.sandbox().isUp() ? "fenced in" : "");
        for (Entrant entrant : trial.entrants()) {
            TeamProgram program = programs.get(entrant.team());
            all.add(program == null ? "" : program.fingerprint());
        }
        return all.text();
    }
}
