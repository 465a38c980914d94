package org.robonewbie.app.command;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.robonewbie.app.program.AgentFinder;
import org.robonewbie.app.program.AgentProgram;
import org.robonewbie.app.program.CalledWronglyException;
import org.robonewbie.app.program.ClassPathOption;
import org.robonewbie.app.program.ExampleCatalogue;
import org.robonewbie.learning.dataset.DataSet;
import org.robonewbie.learning.dataset.RunTables;
import org.robonewbie.learning.dataset.TableFormat;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.server.Simulator;
import org.robonewbie.simulator.server.SimulatorSettings;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Runs an agent many times and writes its perception, its commands and the true state as tables. */
@Command(
        name = "record",
        description = {
            "Let an agent run many times and write a data set.",
            "Its tables hold what the robot felt, what it commanded, what was true, and what happened in the game. docs/datasets.md"
                    + " explains the columns and how to read them."
        },
        customSynopsis = "robonewbie record AGENT [OPTIONS] [-- OPTIONS OF THE AGENT]",
        sortOptions = false,
        footer = {
            "",
            "Examples:",
            "  robonewbie record Agent_SimpleSoccer --runs 20 --seconds 60",
            "  robonewbie record MyAgent.java --runs 100 --seed 7 --seconds 10 --format csv --out falls",
            "  robonewbie record MyAgent.java --runs 5 --messages -- --pose -2,1,90",
            "  robonewbie record MyTeam.java --robots 4           a program that brings four robots"
        })
final class RecordCommand implements Callable<Integer> {

    private static final int MOST_ROBOTS = 22;
    private static final long PATIENCE_SECONDS = 20;

    @Mixin
    final HelpOption help = new HelpOption();

    @Parameters(
            arity = "1..*",
            paramLabel = "AGENT",
            description = "Name of an example, name of a class of yours, or a .java file; then, after --, its options.")
    private List<String> agentAndOptions = List.of();

    @Option(names = "--runs", paramLabel = "N", description = "How many runs (1).")
    private int runs = 1;

    @Option(names = "--seed", paramLabel = "S", description = "Seed of the first run; the next have S+1, S+2, ... (1).")
    private long seed = 1;

    @Option(names = "--seconds", paramLabel = "T", description = "Simulated length of each run (60).")
    private double seconds = 60;

    @Option(names = "--format", paramLabel = "FORMAT", description = "parquet or csv (parquet).")
    private TableFormat format = TableFormat.PARQUET;

    @Option(names = "--out", paramLabel = "FOLDER", description = "A new folder for the data set (dataset).")
    private Path folder = Path.of("dataset");

    @Option(names = "--messages", description = "Keep the messages between simulator and robot as text too.")
    private boolean messages;

    @Option(names = "--robots", paramLabel = "N", description = "How many robots the program brings, 1 to 22 (1).")
    private int robots = 1;

    @Mixin
    private final ClassPathOption classPath = new ClassPathOption();

    @Mixin
    final WithoutStudioOption withoutStudio = new WithoutStudioOption();

    @Override
    public Integer call() throws IOException {
        check();
        List<Path> classFolders = classPath.folders();
        AgentProgram program = new AgentFinder(ExampleCatalogue.load(), classFolders).find(agentAndOptions.get(0));
        DataSet set = create();
        try (RecordingGuard guard = RecordingGuard.begin(set, runs, seconds)) {
            if (set.runs() > 0) {
                System.out.println(set.runs() + " runs are complete already and kept.");
            }
            for (int run = 1; run <= runs; run++) {
                if (set.has(run)) {
                    continue;
                }
                long rows = record(program, set, guard, run);
                System.out.printf(Locale.ROOT, "run %d/%d, seed %d: %d rows%n", run, runs, seed + run - 1, rows);
            }
            set.finish();
        }
        System.out.println("Written to the folder " + folder + "; its dataset.json explains the columns.");
        return ExitCode.OK;
    }

    private void check() {
        if (runs < 1) {
            throw new CalledWronglyException("--runs " + runs + ": give a number of at least 1.");
        }
        if (robots < 1 || robots > MOST_ROBOTS) {
            throw new CalledWronglyException("--robots " + robots + ": give a number from 1 to " + MOST_ROBOTS + ".");
        }
        if (!(seconds > 0) || Double.isInfinite(seconds)) {
            throw new CalledWronglyException("--seconds " + seconds + ": give a number greater than 0.");
        }
    }

    private DataSet create() throws IOException {
        try {
            return DataSet.create(folder, format, messages, facts());
        } catch (IllegalArgumentException occupied) {
            throw new CalledWronglyException(String.valueOf(occupied.getMessage()));
        } catch (IOException unwritable) {
            throw new CalledWronglyException("The folder " + folder + " cannot be written (" + unwritable
                    + "). Name another one with --out, or make room on the disk.");
        }
    }

    private Map<String, String> facts() {
        Map<String, String> facts = new LinkedHashMap<>();
        facts.put("version", new RoboNewbieCommand.Version().getVersion()[0]);
        facts.put("agent", String.join(" ", agentAndOptions));
        facts.put("seconds", Double.toString(seconds));
        facts.put("first seed", Long.toString(seed));
        facts.put("robots", Integer.toString(robots));
        facts.put("pitch", "beginner");
        return facts;
    }

    private long record(AgentProgram program, DataSet set, RecordingGuard guard, int run) throws IOException {
        SimulatorSettings settings = SimulatorSettings.beginner()
                .agentPort(0)
                .synchronous(true)
                .speed(SimulationControl.AS_FAST_AS_POSSIBLE)
                .seed(seed + run - 1)
                .awaitedAgents(robots)
                .seconds(OptionalDouble.of(seconds))
                .build();
        try (RunTables tables = set.begin(run, seed + run - 1)) {
            try (Simulator simulator = Simulator.start(settings, Console.silent())) {
                guard.begins(run, simulator, tables);
                simulator.control().addObserver(tables);
                CompletableFuture.delayedExecutor(PATIENCE_SECONDS, TimeUnit.SECONDS)
                        .execute(() -> giveUpIfNotBegun(simulator));
                int code = silently(program, simulator.agentPort());
                if (code != ExitCode.OK) {
                    throw new IOException(agentAndOptions.get(0) + " failed in run " + run + ", see above.");
                }
            }
            return set.add(tables);
        } finally {
            guard.ends();
        }
    }

    /** The world waits for all robots; if some never come, it would wait for ever. */
    private void giveUpIfNotBegun(Simulator simulator) {
        if (simulator.cycles() == 0) {
            System.err.println(agentAndOptions.get(0) + " has not brought " + robots + " robots within "
                    + PATIENCE_SECONDS + " s. Say with --robots how many it brings.");
            simulator.close();
        }
    }

    /** What the agent prints for people is left out; there may be thousands of runs. */
    private int silently(AgentProgram program, int port) {
        List<String> options =
                new ArrayList<>(List.of("--host", "127.0.0.1", "--port", Integer.toString(port), "--headless"));
        options.addAll(agentAndOptions.subList(1, agentAndOptions.size()));
        PrintStream usual = System.out;
        System.setOut(new PrintStream(OutputStream.nullOutputStream(), false, StandardCharsets.UTF_8));
        try {
            return program.run(options);
        } finally {
            System.setOut(usual);
        }
    }
}
