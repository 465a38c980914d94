package org.robonewbie.app.command;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.robonewbie.agent.policy.file.PolicyFile;
import org.robonewbie.agent.walk.PolicyWalk;
import org.robonewbie.agent.walk.WalkReflex;
import org.robonewbie.agent.walk.WalkStyle;
import org.robonewbie.app.program.CalledWronglyException;
import org.robonewbie.learning.policy.EvolutionStrategy;
import org.robonewbie.learning.policy.PolicyTraining;
import org.robonewbie.learning.policy.TrainingPlan;
import org.robonewbie.learning.policy.WalkCourse;
import org.robonewbie.learning.policy.WalkDash;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Lets a robot learn to walk or to run, and examines what was learned. */
@Command(
        name = "learn",
        description = {
            "Learn to walk or to run by trying, or examine what was learned.",
            "",
            "Writes the policy, FILE.csv with the curve and FILE.checkpoint after each generation; a training that was interrupted goes"
                    + " on with --resume. docs/policies.md explains how it learns and what came of it."
        },
        sortOptions = false,
        footer = {
            "",
            "Examples:",
            "  robonewbie learn walk --generations 500",
            "  robonewbie learn walk --generations 800 --resume",
            "  robonewbie learn walk --start walk.policy --spread 0.02 --rate 0.003 --out better.policy",
            "  robonewbie learn walk --exam walk.policy       how well it follows velocities that change every 3 s",
            "  robonewbie learn walk --exam shipped           the same for the policy of the framework",
            "  robonewbie learn walk --exam fast              the same for the walk engine alone, WalkStyle.FAST; or standard"
        })
final class LearnCommand implements Callable<Integer> {

    @Mixin
    final HelpOption help = new HelpOption();

    @Parameters(paramLabel = "TASK", description = "walk or run.")
    private String task = "walk";

    @Option(names = "--out", paramLabel = "FILE", description = "Where the policy goes (TASK.policy).")
    private @Nullable Path out;

    @Option(names = "--generations", paramLabel = "N", description = "How many generations (500).")
    private int generations = 500;

    @Option(names = "--pairs", paramLabel = "N", description = "Pairs of candidates in a generation (16).")
    private int pairs = 16;

    @Option(names = "--spread", paramLabel = "X", description = "How far candidates lie apart (0.05).")
    private double spread = 0.05;

    @Option(names = "--rate", paramLabel = "X", description = "How far the answer moves in a generation (0.01).")
    private double rate = 0.01;

    @Option(names = "--seconds", paramLabel = "T", description = "Simulated length of a lesson (9).")
    private double seconds = 9;

    @Option(names = "--push", paramLabel = "N", description = "Newtons of the hardest pushes (6).")
    private double push = 6;

    @Option(names = "--seed", paramLabel = "S", description = "The same seed gives the same policy (1).")
    private long seed = 1;

    @Option(names = "--threads", paramLabel = "N", description = "Lessons at the same time (all cores).")
    private int threads = Runtime.getRuntime().availableProcessors();

    @Option(names = "--start", paramLabel = "FILE", description = "Begin with this policy.")
    private @Nullable Path start;

    @Option(names = "--resume", description = "Go on with a training that was interrupted.")
    private boolean resume;

    @Option(
            names = "--exam",
            paramLabel = "FILE",
            description = "Do not learn, but examine: a policy, \"shipped\", \"fast\" or \"standard\".")
    private @Nullable String exam;

    @Option(names = "--lessons", paramLabel = "N", description = "Lessons of the exam (100).")
    private int lessons = 100;

    @Option(
            names = "--dash",
            paramLabel = "METRES",
            description = "With --exam: straight ahead this far, as fast as it can, instead of lessons.")
    private double dash;

    @Override
    public Integer call() throws IOException {
        try {
            WalkCourse course = WalkCourse.of(task);
            return exam == null ? learn(course) : examine(course, exam);
        } catch (IllegalArgumentException | UncheckedIOException wrong) {
            throw new CalledWronglyException(String.valueOf(wrong.getMessage()));
        }
    }

    private int learn(WalkCourse course) throws IOException {
        Path file = out == null ? Path.of(course.task() + ".policy") : out;
        TrainingPlan plan = new TrainingPlan(seed, generations, pairs, spread, rate, seconds, push, threads);
        PolicyTraining training = new PolicyTraining(course, plan, file, history(file));
        training.run(begin(training), System.out::println);
        System.out.println("Written to " + file + "; its curve is " + training.curve() + ".");
        return ExitCode.OK;
    }

    /** How the policy was learned with which the training began; the last line is its own. */
    private List<String> history(Path file) {
        if (resume && Files.exists(file)) {
            List<String> all = PolicyFile.read(file).about();
            return all.subList(0, Math.max(0, all.size() - 1));
        }
        return start == null ? List.of() : PolicyFile.read(start).about();
    }

    private EvolutionStrategy.State begin(PolicyTraining training) throws IOException {
        if (resume) {
            if (!Files.exists(training.checkpoint())) {
                throw new CalledWronglyException("There is nothing to resume: " + training.checkpoint()
                        + " does not exist. Leave out --resume.");
            }
            return training.resume();
        }
        if (Files.exists(training.checkpoint())) {
            throw new CalledWronglyException("There is a training in " + training.checkpoint()
                    + " already. Go on with --resume, choose another --out, or delete it.");
        }
        return start == null ? training.begin() : training.begin(PolicyFile.read(start));
    }

    private int examine(WalkCourse course, String what) {
        if (lessons < 1 || threads < 1 || !(seconds > 0)) {
            throw new CalledWronglyException("--lessons, --threads and --seconds have to be greater than 0.");
        }
        PolicyWalk walk = examined(course, what);
        if (dash > 0) {
            return dash(walk);
        }
        System.out.printf(
                Locale.ROOT,
                "%s, %d lessons of %.0f s: %s%n",
                what,
                lessons,
                seconds,
                PolicyTraining.examine(course, walk, lessons, seconds, push, threads));
        return ExitCode.OK;
    }

    private int dash(PolicyWalk walk) {
        List<WalkDash> dashes = PolicyTraining.dash(walk, dash, push, lessons, threads);
        dashes.forEach(System.out::println);
        System.out.printf(
                Locale.ROOT,
                "%d of %d without a fall; median %.3f m/s%n",
                dashes.stream().filter(one -> !one.fallen()).count(),
                lessons,
                dashes.stream().map(WalkDash::speed).sorted().toList().get(lessons / 2));
        return ExitCode.OK;
    }

    private static PolicyWalk examined(WalkCourse course, String what) {
        return switch (what) {
            case "shipped" -> new PolicyWalk(PolicyFile.shipped(course.task()));
            case "fast" -> new PolicyWalk(WalkStyle.FAST, WalkReflex.NONE);
            case "standard" -> new PolicyWalk(WalkStyle.STANDARD, WalkReflex.NONE);
            default -> new PolicyWalk(PolicyFile.read(Path.of(what)));
        };
    }
}
