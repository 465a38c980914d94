package org.robonewbie.app.command;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.robonewbie.app.studio.ContestStudio;
import org.robonewbie.competition.Competition;
import org.robonewbie.competition.CompetitionSettings;
import org.robonewbie.competition.contest.Conditions;
import org.robonewbie.competition.contest.Contest;
import org.robonewbie.competition.contest.Contests;
import org.robonewbie.competition.contest.JudgedContest;
import org.robonewbie.competition.contest.Table;
import org.robonewbie.competition.team.TeamEntry;
import org.robonewbie.competition.team.TeamList;
import org.robonewbie.competition.trial.Spectators;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Exercises;
import org.robonewbie.programs.CalledWronglyException;
import org.robonewbie.programs.ExampleCatalogue;
import org.robonewbie.programs.process.Limits;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code robonewbie competition}: runs a contest between the programs of several teams. */
@Command(
        name = CompetitionCommand.NAME,
        description = {
            "Run a contest between the programs of up to ten teams, and rank them.",
            "",
            "Each program runs in a separate process, which bubblewrap isolates on Linux. A program that fails costs its team the trial and nothing else."
                    + " The same seed and programs give the same table. After an interruption, the same command resumes the contest."
        },
        sortOptions = false,
        footer = {
            "",
            "Examples:",
            "  robonewbie competition scoring Red=teams/red Blue=blue.jar Agent_SimpleSoccer",
            "  robonewbie competition scoring --teams teams.properties --seed 7 --vary",
            "  robonewbie competition penalties --rounds 5 --teams teams.properties",
            "  robonewbie competition matches --players 3 Red=red Red.together=yes Blue=blue",
            "  robonewbie competition league --players 3 Red=my-team Blue=Agent_Team Green=Agent_BetterSoccer",
            "  robonewbie competition walk --watch Agent_BetterSoccer Agent_SimpleWalkToBall",
            "  robonewbie competition exercise:dance --rounds 3 Red=red Blue=blue",
            "  robonewbie competition scoring \"Green=python3 green.py --port {port} --team {team}\"",
            "",
            "Exit code: 0 if all teams played, 1 if a team's files were rejected and only the other teams played.",
            "",
            "A team is NAME=PROGRAM; a program is a folder with Java files, a jar, a .java file, an example, or a"
                    + " command. A teams file lists one team per line. docs/competition.md explains the details and"
                    + " contains a rule sheet to hand out."
        })
final class CompetitionCommand implements Callable<Integer> {

    static final String NAME = "competition";

    @Mixin
    final HelpOption help = new HelpOption();

    @Parameters(
            index = "0",
            paramLabel = "CONTEST",
            description = "One of the contests listed below, or exercise:NAME, graded as by \"robonewbie grade\".")
    private String kind = "";

    @Parameters(
            index = "1..*",
            arity = "0..*",
            paramLabel = "TEAM",
            description = "NAME=PROGRAM, or a program alone, or NAME.SETTING=VALUE.")
    private List<String> entries = List.of();

    @Option(names = "--teams", paramLabel = "FILE", description = "Read the teams from a file.")
    private Optional<Path> teamsFile = Optional.empty();

    @Option(
            names = "--results",
            paramLabel = "FOLDER",
            description = "Folder for results (default: competition-CONTEST).")
    private Optional<Path> results = Optional.empty();

    @Option(names = "--seed", paramLabel = "S", description = "Seed for all random numbers (default: 1).")
    private long seed = 1;

    @Option(names = "--vary", description = "Vary the start positions with the seed; they are the same for all teams.")
    private boolean varied;

    @Option(
            names = "--seconds",
            paramLabel = "T",
            description = "Length of each trial in simulated seconds (default: scoring 180, penalties 30, matches and"
                    + " league 300).")
    private Optional<Double> seconds = Optional.empty();

    @Option(
            names = "--rounds",
            paramLabel = "N",
            description = "penalties: rounds before sudden death; exercises: trials per team (default: 3).")
    private int rounds = 3;

    @Option(
            names = "--players",
            paramLabel = "N",
            description = "matches, league: robots per team, 1 to 11 (default: 1).")
    private int players = 1;

    @Option(
            names = "--parallel",
            paramLabel = "N",
            description = "Trials that run in parallel (default: one per processor).")
    private Optional<Integer> parallel = Optional.empty();

    @Option(
            names = "--memory",
            paramLabel = "MB",
            description = "Memory limit of each program (default: ${DEFAULT-VALUE}).")
    private int memoryMegabytes = Limits.DEFAULT.memoryMegabytes();

    @Option(
            names = "--patience",
            paramLabel = "T",
            description = "Seconds by which a program may delay the simulation (default: ${DEFAULT-VALUE}).")
    private double silentSeconds = Limits.DEFAULT.silentSeconds();

    @Option(
            names = "--computing-time",
            paramLabel = "T",
            description =
                    "Processor time limit for each program in each trial, in seconds (default: ${DEFAULT-VALUE}).")
    private double processorSeconds = Limits.DEFAULT.processorSeconds();

    @Mixin
    private final FenceOption fence = new FenceOption();

    @Option(
            names = "--watch",
            description = "Show the running trials side by side in real time, and the current table.")
    private boolean watched;

    @Option(
            names = "--no-browser",
            description = "With --watch: print the address of the page instead of opening a browser.")
    private boolean withoutBrowser;

    @Option(names = "--headless", description = "Overrides --watch: do not open the studio.")
    private boolean headless;

    @Override
    public Integer call() throws IOException, InterruptedException {
        // report an unknown contest before missing teams
        Contest contest = contest(Conditions.of(seed));
        List<TeamEntry> teams = teams(contest instanceof JudgedContest ? 2 : 1);
        return hold(contest(conditions(teams)), teams);
    }

    /** Returns the rules of all contests for the help text. */
    static Map<String, String> rules() {
        Map<String, String> rules = new LinkedHashMap<>();
        Contests.usual().forEach(contest -> rules.put(contest.name(), contest.rule()));
        return rules;
    }

    private int hold(Contest contest, List<TeamEntry> teams) throws IOException, InterruptedException {
        Path folder = results.orElse(Path.of("competition-" + contest.name()));
        System.out.println(contest.title() + ": " + contest.rule());
        if (!watched || headless) {
            return hold(new Competition(contest, teams, settings(folder, Spectators.NOBODY), System.out), folder);
        }
        try (ContestStudio studio = ContestStudio.open(contest, folder)) {
            System.out.println("Watch at " + studio.invitation());
            if (!withoutBrowser) {
                studio.showBrowser();
            }
            int exitCode = hold(new Competition(contest, teams, settings(folder, studio), System.out), folder);
            studio.isOver(place(folder));
            return exitCode;
        }
    }

    /** Runs the contest; the exit code indicates whether all teams took part. */
    private static int hold(Competition competition, Path results) throws IOException, InterruptedException {
        print(competition.hold());
        System.out.println(place(results));
        List<String> refused = competition.refusedTeams();
        if (refused.isEmpty()) {
            return ExitCode.OK;
        }
        System.err.println(
                "Rejected: " + String.join(", ", refused) + ". The reasons are printed above; all other teams played."
                        + " Fix the files and run the same command again to let them play.");
        return ExitCode.SOFTWARE;
    }

    private static String place(Path results) {
        return "Table, certificates and recordings: " + results.resolve("table.html");
    }

    private CompetitionSettings settings(Path folder, Spectators spectators) {
        return new CompetitionSettings(
                seed,
                folder,
                teamsFile
                        .map(file -> Optional.ofNullable(file.toAbsolutePath().getParent())
                                .orElse(Path.of("")))
                        .orElse(Path.of("")),
                ExampleCatalogue.classNames(),
                Math.max(1, parallel.orElse(Runtime.getRuntime().availableProcessors())),
                new Limits(
                        memoryMegabytes,
                        processorSeconds,
                        silentSeconds,
                        Limits.DEFAULT.startSeconds(),
                        Limits.DEFAULT.realSeconds()),
                fence.sandbox(),
                spectators);
    }

    private List<TeamEntry> teams(int needed) {
        List<TeamEntry> teams = teamsFile.isPresent() ? TeamList.read(teamsFile.get()) : TeamList.parse(entries);
        if (teamsFile.isPresent() && !entries.isEmpty()) {
            throw new CalledWronglyException("Teams are listed both in " + teamsFile.get()
                    + " and on the command line. List all of them in the file, or omit --teams.");
        }
        if (teams.size() < needed) {
            throw new CalledWronglyException("This contest needs at least " + needed + " team"
                    + (needed == 1 ? "" : "s") + ". For example: robonewbie competition " + kind
                    + " Red=Agent_BetterSoccer Blue=Agent_SimpleSoccer");
        }
        return teams;
    }

    private Conditions conditions(List<TeamEntry> teams) {
        Map<String, Long> seeds = new HashMap<>();
        teams.forEach(team -> team.seed().ifPresent(own -> seeds.put(team.name(), own)));
        return new Conditions(seed, varied, seeds);
    }

    private Contest contest(Conditions conditions) {
        if (players < 1
                || players > 11
                || rounds < 1
                || seconds.filter(time -> time <= 0).isPresent()) {
            throw new CalledWronglyException("--players must be 1 to 11, --rounds at least 1, and --seconds above 0.");
        }
        if (kind.startsWith(ExerciseContests.PREFIX)) {
            String name = kind.substring(ExerciseContests.PREFIX.length());
            Exercise exercise = Exercises.find(name).orElseThrow(() -> GradeCommand.unknown(name));
            return ExerciseContests.of(exercise, rounds, conditions);
        }
        return Contests.all(conditions, rounds, players, seconds).stream()
                .filter(contest -> contest.name().equals(kind))
                .findFirst()
                .orElseThrow(() -> new CalledWronglyException("Unknown contest \"" + kind + "\". Choose one of: "
                        + String.join(", ", rules().keySet()) + ", and exercise:NAME, such as exercise:dance."));
    }

    private static void print(Table table) {
        List<List<String>> lines = new ArrayList<>();
        List<String> head = new ArrayList<>(List.of("", "Team"));
        head.addAll(table.columns());
        lines.add(head);
        for (Table.Row row : table.rows()) {
            List<String> line = new ArrayList<>(List.of(row.rank() + ".", row.team()));
            line.addAll(row.cells());
            lines.add(line);
        }
        System.out.println();
        for (List<String> line : lines) {
            StringBuilder text = new StringBuilder();
            for (int i = 0; i < line.size(); i++) {
                int column = i;
                int width = lines.stream()
                        .mapToInt(other -> other.get(column).length())
                        .max()
                        .orElse(0);
                text.append(String.format("%-" + Math.max(1, width) + "s  ", line.get(i)));
            }
            System.out.println(text.toString().stripTrailing());
        }
        System.out.println();
    }
}
