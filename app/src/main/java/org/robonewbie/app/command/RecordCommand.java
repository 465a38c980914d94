package org.robonewbie.app.command;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.robonewbie.agent.Options;
import org.robonewbie.agent.StartUpException;
import org.robonewbie.learning.dataset.DataSet;
import org.robonewbie.learning.dataset.Recording;
import org.robonewbie.learning.dataset.RunVariation;
import org.robonewbie.nao.file.FolderLock;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.programs.CalledWronglyException;
import org.robonewbie.programs.ProgramFinder;
import org.robonewbie.programs.process.WorkerPool;
import org.robonewbie.simulator.soccer.SoccerParameter;
import org.robonewbie.simulator.soccer.SoccerParameters;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Runs an agent many times and writes its perception, its commands and the ground truth as tables. */
@Command(
        name = "record",
        description = {
            "Run an agent many times and write a data set.",
            "Its CSV tables contain perception, commands, ground truth and game events. docs/datasets.md"
                    + " explains the columns, how to read them, and how to convert them to Parquet.",
            "Runs use all cores; this does not affect the tables. The table of runs lists each failed run with the"
                    + " reason.",
            "Run the command again to resume an interrupted recording."
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
            "  robonewbie record MyAgent.java --runs 40 --option friction=0.7..1.3 --option push=20",
            "  robonewbie record MyTeam.java --robots 4           a program with four robots"
        })
final class RecordCommand implements Callable<Integer> {

    private static final String LOCK = ".record.lock";

    private static final int MAX_ROBOTS = 22;

    @Mixin
    final HelpOption help = new HelpOption();

    @Parameters(
            arity = "1..*",
            paramLabel = "AGENT",
            description = "An example, a class or a .java file; its options follow after --.")
    private List<String> agentAndOptions = List.of();

    @Option(names = "--runs", paramLabel = "N", description = "Number of runs (default: 1).")
    private int runs = 1;

    @Option(
            names = "--seed",
            paramLabel = "S",
            description = "Seed of the first run; the next runs use S+1, S+2, ... (default: 1).")
    private long seed = 1;

    @Option(
            names = "--seconds",
            paramLabel = "T",
            description = "Length of each run in simulated seconds (default: 60).")
    private double seconds = 60;

    @Option(names = "--out", paramLabel = "FOLDER", description = "New folder for the data set (default: dataset).")
    private Path folder = Path.of("dataset");

    @Option(names = "--messages", description = "Add the messages between simulator and robot as text.")
    private boolean messages;

    @Option(
            names = "--runs-per-file",
            paramLabel = "N",
            description = "Combine the tables of N runs into one file (default: 1).")
    private int runsPerFile = 1;

    @Option(names = "--threads", paramLabel = "N", description = "Number of parallel runs (default: one per core).")
    private int threads = Runtime.getRuntime().availableProcessors();

    @Option(
            names = "--robots",
            paramLabel = "N",
            description = "Number of robots that the program runs, 1 to 22 (default: 1).")
    private int robots = 1;

    @Option(
            names = "--spread",
            paramLabel = "METRES,DEGREES",
            split = ",",
            description =
                    "Maximum random offset of robots and ball at the start of each run, and maximum turn of a robot"
                            + " (default: 0.2,10).")
    private List<Double> spread = List.of(0.2, 10.0);

    @Option(names = "--league", description = "Pitch and rules of the league (default: those for beginners).")
    private boolean league;

    @Option(
            names = "--option",
            paramLabel = "NAME=VALUE",
            description = "friction or mass, a factor, or push, the newtons of the hardest push, with one per second: a"
                    + " number, or a range LOW..HIGH from which each run draws.")
    private List<String> options = List.of();

    @Mixin
    private final ClassPathOption classPath = new ClassPathOption();

    @Override
    public Integer call() throws IOException {
        check();
        RunVariation variation = variation();
        checkPose(variation.parameters());
        String agent = agentAndOptions.get(0);
        new ProgramFinder(classPath.folders()).findRepeatedly(agent); // reports an invalid program before the recording
        DataSet set = create(variation);
        FolderLock lock = FolderLock.take(folder.resolve(LOCK))
                .orElseThrow(() -> new CalledWronglyException("Another recording is using the folder " + folder
                        + ". Wait until it ends, or choose another folder with --out."));
        Thread hook = new Thread(() -> endEarly(set), "end-of-recording");
        Runtime.getRuntime().addShutdownHook(hook);
        try (lock;
                WorkerPool workers = new WorkerPool(agent, classPath.folders())) {
            if (set.runs() > 0) {
                System.out.println(set.runs() + " runs are already complete and are kept.");
            }
            new Recording(set, runs, robots, seconds, seed, variation)
                    .run(threads, port -> workers.run(options(port)), System.out::println);
            return end(set);
        } finally {
            remove(hook);
            Files.deleteIfExists(folder.resolve(LOCK));
        }
    }

    private List<String> options(int port) {
        List<String> options =
                new ArrayList<>(List.of("--host", "127.0.0.1", "--port", Integer.toString(port), "--headless"));
        options.addAll(agentAndOptions.subList(1, agentAndOptions.size()));
        return options;
    }

    private static void remove(Thread hook) {
        try {
            Runtime.getRuntime().removeShutdownHook(hook);
        } catch (IllegalStateException shutdown) {
            // The JVM is already shutting down and will run the hook.
        }
    }

    /** Completes the table of runs when this process is terminated during the recording, for example with Ctrl+C. */
    private void endEarly(DataSet set) {
        try {
            set.endEarly();
            System.err.println("robonewbie: The recording was interrupted. " + set.runs() + " of " + runs
                    + " runs are complete and kept. Run the command again to resume.");
        } catch (IOException unwritable) {
            System.err.println("robonewbie: The table of runs cannot be written: " + unwritable.getMessage());
        }
        System.err.flush();
        Runtime.getRuntime().halt(1);
    }

    private int end(DataSet set) throws IOException {
        if (set.runs() == runs) {
            set.finish(runsPerFile);
            System.out.println(
                    "The data set was written to the folder " + folder + ". Its dataset.json explains the columns.");
        } else {
            set.endEarly();
            System.err.println(set.runs() + " of " + runs + " runs are complete and kept in the folder " + folder
                    + ". Run the command again to retry the missing ones.");
        }
        set.failures()
                .forEach(run -> System.err.println("run " + run.run() + ", seed " + run.seed() + ": " + run.failure()));
        return set.failures().isEmpty() && set.runs() == runs ? ExitCode.OK : ExitCode.SOFTWARE;
    }

    private void check() {
        if (runs < 1) {
            throw new CalledWronglyException("--runs must be at least 1, not " + runs + ".");
        }
        if (robots < 1 || robots > MAX_ROBOTS) {
            throw new CalledWronglyException("--robots must be from 1 to " + MAX_ROBOTS + ", not " + robots + ".");
        }
        if (!(seconds > 0) || Double.isInfinite(seconds)) {
            throw new CalledWronglyException("--seconds must be greater than 0, not " + seconds + ".");
        }
        if (threads < 1) {
            throw new CalledWronglyException("--threads must be at least 1, not " + threads + ".");
        }
        if (runsPerFile < 1) {
            throw new CalledWronglyException("--runs-per-file must be at least 1, not " + runsPerFile + ".");
        }
    }

    private RunVariation variation() {
        if (spread.size() != 2) {
            throw new CalledWronglyException("--spread needs two numbers, such as 0.2,10. Given: " + spread + ".");
        }
        try {
            return RunVariation.of(league, spread.get(0), spread.get(1), options);
        } catch (IllegalArgumentException wrong) {
            throw new CalledWronglyException(String.valueOf(wrong.getMessage()));
        }
    }

    /** Refuses a starting pose outside of the pitch. */
    private void checkPose(SoccerParameters parameters) {
        double x = parameters.field().length() / 2;
        double y = parameters.field().width() / 2;
        double most = parameters.isOn(SoccerParameter.START_ANY_FIELD_POSITION) ? x : 0;
        pose().ifPresent(pose -> {
            if (pose.x() < -x || pose.x() > most || Math.abs(pose.y()) > y) {
                throw new CalledWronglyException(String.format(
                        Locale.ROOT,
                        "The starting pose (%s, %s) is outside of the pitch. Choose x from %s to %s m and y from %s to %s m.",
                        pose.x(),
                        pose.y(),
                        -x,
                        most,
                        -y,
                        y));
            }
        });
    }

    /** Returns the starting pose that the agent's options set; empty if they include options that the agent itself defines. */
    private Optional<Pose2d> pose() {
        try {
            return Options.of(agentAndOptions.stream().skip(1).toArray(String[]::new))
                    .pose();
        } catch (StartUpException unknown) {
            return Optional.empty();
        }
    }

    private DataSet create(RunVariation variation) {
        Map<String, String> facts = new LinkedHashMap<>();
        facts.put("version", ProgramVersion.line());
        facts.put("agent", String.join(" ", agentAndOptions));
        facts.put("seconds", Double.toString(seconds));
        facts.put("first seed", Long.toString(seed));
        facts.put("robots", Integer.toString(robots));
        facts.put("pitch", variation.isLeague() ? "league" : "beginner");
        if (variation.isRandom()) {
            facts.put("spread and options", variation.toString());
        }
        try {
            return DataSet.create(folder, messages, facts);
        } catch (IllegalArgumentException occupied) {
            throw new CalledWronglyException(String.valueOf(occupied.getMessage()));
        } catch (IOException unwritable) {
            throw new CalledWronglyException("Cannot write to the folder " + folder + " (" + unwritable
                    + "). Choose another one with --out, or free up some disk space.");
        }
    }
}
