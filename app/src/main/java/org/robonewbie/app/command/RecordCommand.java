package org.robonewbie.app.command;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.function.Supplier;
import org.robonewbie.app.recording.ParallelRecording;
import org.robonewbie.app.recording.RecordingGuard;
import org.robonewbie.app.recording.RunOrder;
import org.robonewbie.app.recording.RunsOnCall;
import org.robonewbie.learning.dataset.DataSet;
import org.robonewbie.nao.file.FolderLock;
import org.robonewbie.programs.CalledWronglyException;
import org.robonewbie.programs.ExampleCatalogue;
import org.robonewbie.programs.Program;
import org.robonewbie.programs.ProgramFinder;
import org.robonewbie.programs.process.JavaCommand;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Runs an agent many times and writes its perception, its commands and the true state as tables. */
@Command(
        name = "record",
        description = {
            "Let an agent run many times and write a data set.",
            "Its tables hold what the robot felt, what it commanded, what was true, and what happened in the game, as CSV. docs/datasets.md"
                    + " explains the columns, how to read them, and how to make Parquet of them.",
            "Runs are carried out on all cores; which one a run gets does not change its tables. The table of runs says which have failed",
            "and why. After a kill the same command goes on where it was."
        },
        customSynopsis = "robonewbie record AGENT [OPTIONS] [-- OPTIONS OF THE AGENT]",
        sortOptions = false,
        footer = {
            "",
            "Examples:",
            "  robonewbie record Agent_SimpleSoccer --runs 20 --seconds 60",
            "  robonewbie record MyAgent.java --runs 100 --seed 7 --seconds 10 --out falls",
            "  robonewbie record MyAgent.java --runs 1000 --seconds 10 --runs-per-file 100",
            "  robonewbie record MyAgent.java --runs 5 --messages -- --pose -2,1,90",
            "  robonewbie record MyTeam.java --robots 4           a program that brings four robots"
        })
final class RecordCommand implements Callable<Integer> {

    private static final String LOCK = ".record.lock";

    private static final int MOST_ROBOTS = 22;

    @Spec
    private CommandSpec spec = CommandSpec.create();

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

    @Option(names = "--out", paramLabel = "FOLDER", description = "A new folder for the data set (dataset).")
    private Path folder = Path.of("dataset");

    @Option(names = "--messages", description = "Keep the messages between simulator and robot as text too.")
    private boolean messages;

    @Option(names = "--runs-per-file", paramLabel = "N", description = "Join the tables of N runs into one file (1).")
    private int runsPerFile = 1;

    @Option(names = "--threads", paramLabel = "N", description = "How many runs at the same time (one per core).")
    private int threads = Runtime.getRuntime().availableProcessors();

    @Option(names = RunsOnCall.OPTION, hidden = true)
    private boolean onCall;

    @Option(names = "--robots", paramLabel = "N", description = "How many robots the program brings, 1 to 22 (1).")
    private int robots = 1;

    @Mixin
    private final ClassPathOption classPath = new ClassPathOption();

    @Override
    public Integer call() throws IOException, InterruptedException {
        check();
        RunOrder order = new RunOrder(agentAndOptions, robots, seconds, seed);
        Supplier<Program> programs =
                new ProgramFinder(ExampleCatalogue.load(), classPath.folders()).findRepeatedly(order.agent());
        if (onCall) {
            new RunsOnCall(order, programs, DataSet.joined(folder, messages, facts(order))).serve();
        }
        DataSet set = create(order);
        FolderLock lock = FolderLock.take(folder.resolve(LOCK))
                .orElseThrow(() -> new CalledWronglyException("Another recording is using the folder " + folder
                        + ". Wait for its end, or choose another folder with --out."));
        RecordingGuard guard = RecordingGuard.begin(set, runs);
        try (lock) {
            if (set.runs() > 0) {
                System.out.println(set.runs() + " runs are complete already and kept.");
            }
            new ParallelRecording(order, runs, set, JavaCommand.ofCommand(argumentsOnCall())).run(threads);
            return end(set);
        } finally {
            guard.close();
            Files.deleteIfExists(folder.resolve(LOCK));
        }
    }

    private int end(DataSet set) throws IOException {
        if (set.runs() == runs) {
            set.finish(runsPerFile);
            System.out.println("Written to the folder " + folder + "; its dataset.json explains the columns.");
        } else {
            set.endEarly();
            System.err.println(set.runs() + " of " + runs + " runs are complete and kept in the folder " + folder
                    + "; the same command tries again what is missing.");
        }
        set.failures()
                .forEach(run -> System.err.println("run " + run.run() + ", seed " + run.seed() + ": " + run.failure()));
        return set.failures().isEmpty() && set.runs() == runs ? ExitCode.OK : ExitCode.SOFTWARE;
    }

    /** What a process gets that carries out runs: all that this one got. */
    private List<String> argumentsOnCall() {
        List<String> arguments =
                new ArrayList<>(spec.root().commandLine().getParseResult().originalArgs());
        arguments.add(arguments.indexOf(spec.name()) + 1, RunsOnCall.OPTION);
        return arguments;
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
        if (threads < 1) {
            throw new CalledWronglyException("--threads " + threads + ": give a number of at least 1.");
        }
        if (runsPerFile < 1) {
            throw new CalledWronglyException("--runs-per-file " + runsPerFile + ": give a number of at least 1.");
        }
    }

    private DataSet create(RunOrder order) {
        try {
            return DataSet.create(folder, messages, facts(order));
        } catch (IllegalArgumentException occupied) {
            throw new CalledWronglyException(String.valueOf(occupied.getMessage()));
        } catch (IOException unwritable) {
            throw new CalledWronglyException("The folder " + folder + " cannot be written (" + unwritable
                    + "). Name another one with --out, or make room on the disk.");
        }
    }

    private static Map<String, String> facts(RunOrder order) {
        return order.facts(new RoboNewbieCommand.Version().getVersion()[0]);
    }
}
