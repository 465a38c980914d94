package org.robonewbie.workshop;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.file.AtomicFile;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.workshop.load.ExampleLoad;
import org.robonewbie.workshop.motion.CheckResult;
import org.robonewbie.workshop.motion.MotionMeasurement;
import org.robonewbie.workshop.team.AgentMeasurement;
import org.robonewbie.workshop.team.PlayerChecks;
import org.robonewbie.workshop.team.TeamMeasurement;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.ScopeType;

/** Command line of the workshop: measures motions, agents, and the speed and fidelity of the simulator. */
@Command(
        name = "bench",
        description = "Measure motions, agents and the simulator on this computer.",
        synopsisSubcommandLabel = "SUBJECT",
        commandListHeading = "%nSubjects:%n",
        sortOptions = false,
        subcommands = {
            ServerCommand.class,
            SpeedCommand.class,
            FidelityCommand.class,
            RecordCommand.class,
            SparringCommand.class
        },
        footer = {
            "",
            "Examples:",
            "  bench motions --seeds 3     try each shipped motion three times",
            "  bench examples              how long does each example think?",
            "  bench server --fast         play with 22 robots over TCP",
            "  bench sparring              how does the example team play against fixed partners?",
            "  bench speed --robots 1,22   how fast is a step?",
            "  bench fidelity              how close is it to the real rcssserver3d?",
            "  bench speed --help          help for one command",
            "",
            "bench is short for: java -jar workshop/target/bench.jar"
        })
public final class Bench {

    @Option(
            names = {"-h", "--help"},
            usageHelp = true,
            scope = ScopeType.INHERIT,
            description = "Show this help.")
    boolean help;

    static final int MAX_ROBOTS = 22;
    static final int MAX_TYPE = RobotType.values().length - 1;

    private Bench() {}

    /** Returns the value of an option, or throws if it is out of range. */
    static int checked(String option, int value, int min, int max) {
        if (value < min || value > max) {
            String range = max == Integer.MAX_VALUE ? "at least " + min : "from " + min + " to " + max;
            throw new IllegalArgumentException(option + " must be " + range + ", not " + value + ".");
        }
        return value;
    }

    /** Throws if a simulated time in seconds is not greater than 0. */
    static void checkSeconds(String option, double value) {
        if (!(value > 0 && value <= 1e6)) {
            throw new IllegalArgumentException(
                    option + " " + value + " is not valid. Use a number of simulated seconds above 0, such as 20.");
        }
    }

    /**
     * Runs a measurement.
     *
     * @param arguments name of the measurement, followed by its options
     */
    public static void main(String... arguments) {
        System.exit(commandLine().execute(arguments));
    }

    /** Creates the command. Invalid option values are reported in one sentence with exit code 2. */
    static CommandLine commandLine() {
        return new CommandLine(new Bench())
                .setCaseInsensitiveEnumValuesAllowed(true)
                .setUsageHelpAutoWidth(true)
                .setExecutionExceptionHandler((failure, command, parsed) -> {
                    if (failure instanceof IllegalArgumentException) {
                        command.getErr().println(failure.getMessage());
                        return ExitCode.USAGE;
                    }
                    throw failure;
                });
    }

    /** Options for the number and seeds of trials. */
    static final class Trials {

        @Option(
                names = "--seeds",
                paramLabel = "N",
                description = "Number of trials, each with a different disturbance (default: 20).")
        private int seeds = 20;

        @Option(names = "--first-seed", paramLabel = "N", description = "Seed of the first trial (default: 1).")
        private long firstSeed = 1;

        private int seeds() {
            return checked("--seeds", seeds, 1, Integer.MAX_VALUE);
        }
    }

    @Command(
            description = "Try all shipped motions many times in the simulator.",
            footer = {
                "",
                "Examples:",
                "  bench motions                20 trials of each motion",
                "  bench motions --seeds 3      a quick look",
                "  bench motions --first-seed 1000 --json result.json"
            })
    void motions(
            @Mixin Trials trials,
            @Option(
                            names = "--only",
                            paramLabel = "PART",
                            defaultValue = "",
                            description = "Measure only motions whose name contains this text, such as kick.")
                    String part,
            @Option(
                            names = "--type",
                            paramLabel = "0..4",
                            defaultValue = "0",
                            description =
                                    "Robot type; types 1 to 4 walk only in the full simulator (default: ${DEFAULT-VALUE}).")
                    int type,
            @Option(names = "--json", paramLabel = "FILE", description = "Also write the results as JSON.")
                    Optional<Path> json,
            @Option(names = "--table", paramLabel = "FILE", description = "Also write the results as a Markdown table.")
                    Optional<Path> table)
            throws IOException {
        RobotType built = RobotType.values()[checked("--type", type, 0, MAX_TYPE)];
        List<CheckResult> results = new MotionMeasurement(trials.seeds(), trials.firstSeed, part, built, System.out)
                .with(PlayerChecks.all(built))
                .run(json);
        if (table.isPresent()) {
            AtomicFile.write(table.get(), CheckResult.table(results));
        }
    }

    @Command(
            description = "Play many games with each example agent.",
            footer = {"", "Example:", "  bench agents                 20 games of each example agent"})
    void agents(
            @Mixin Trials trials,
            @Option(
                            names = "--only",
                            paramLabel = "PART",
                            defaultValue = "",
                            description = "Measure only agents whose name contains this text, such as Better.")
                    String part,
            @Option(names = "--json", paramLabel = "FILE", description = "Also write the results as JSON.")
                    Optional<Path> json)
            throws IOException {
        new AgentMeasurement(trials.seeds(), trials.firstSeed, System.out).run(part, json);
    }

    @Command(
            description = "Measure the think time of each example in real time, and the cycles that it misses.",
            footer = {
                "",
                "Examples:",
                "  bench examples                     9 minutes: the table in docs/performance.md",
                "  bench examples --only Soccer --seconds 5",
                "",
                "Agent_KeyframeDeveloper writes the file motions/my-motion.txt into the working directory."
            })
    void examples(
            @Option(
                            names = "--only",
                            paramLabel = "PART",
                            defaultValue = "",
                            description = "Measure only examples whose name contains this text, such as Soccer.")
                    String part,
            @Option(
                            names = "--warm-up",
                            paramLabel = "T",
                            defaultValue = "5",
                            description = "Simulated seconds before each measurement (default: ${DEFAULT-VALUE}).")
                    double warmUpSeconds,
            @Option(
                            names = "--seconds",
                            paramLabel = "T",
                            defaultValue = "20",
                            description = "Measured seconds of each example (default: ${DEFAULT-VALUE}).")
                    double seconds)
            throws IOException {
        checkSeconds("--warm-up", warmUpSeconds);
        checkSeconds("--seconds", seconds);
        new ExampleLoad(warmUpSeconds, seconds).run(part, System.out);
    }

    @Command(
            description = "Play halves with the example team against a team of the same size.",
            footer = {
                "",
                "Examples:",
                "  bench team --players 3       20 halves, 3 against 3",
                "  bench team --players 1       one player alone, 5 minutes on the game's clock"
            })
    void team(
            @Mixin Trials trials,
            @Option(
                            names = "--players",
                            paramLabel = "N",
                            defaultValue = "3",
                            description =
                                    "Players per team, 1 to 11; a single player plays alone (default: ${DEFAULT-VALUE}).")
                    int players,
            @Option(
                            names = "--against",
                            paramLabel = "AGENT",
                            defaultValue = TeamMeasurement.DEFAULT_OPPONENT,
                            description =
                                    "The opponents, Agent_BetterSoccer or Agent_Team (default: ${DEFAULT-VALUE}).")
                    String opponent) {
        new TeamMeasurement(trials.seeds(), trials.firstSeed, System.out)
                .run(checked("--players", players, 1, 11), opponent);
    }
}
