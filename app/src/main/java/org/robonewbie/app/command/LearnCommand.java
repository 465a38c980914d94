package org.robonewbie.app.command;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.robonewbie.agent.policy.Policy;
import org.robonewbie.agent.policy.file.PolicyFile;
import org.robonewbie.agent.walk.PolicyWalk;
import org.robonewbie.agent.walk.WalkReflex;
import org.robonewbie.agent.walk.WalkStyle;
import org.robonewbie.learning.gym.TaskCourse;
import org.robonewbie.learning.policy.Course;
import org.robonewbie.learning.policy.EvolutionStrategy;
import org.robonewbie.learning.policy.Exam;
import org.robonewbie.learning.policy.LessonFigures;
import org.robonewbie.learning.policy.PolicyTraining;
import org.robonewbie.learning.policy.TrainingPlan;
import org.robonewbie.learning.policy.WalkCourse;
import org.robonewbie.learning.policy.WalkDash;
import org.robonewbie.programs.CalledWronglyException;
import org.robonewbie.programs.ProgramFinder;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Lets a robot learn to walk, to jog, to run or any task for one robot, and examines what was learned. */
@Command(
        name = "learn",
        description = {
            "Learn to walk, to jog, to run, or a task of the Python package by trying, or examine what was learned.",
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
            "  robonewbie learn Stand --option noise=0.3      a task of the Python package, or a class of yours",
            "  robonewbie learn Stand --exam shipped --lessons 20",
            "  robonewbie learn Stand --exam none             the same without having learned anything",
            "  robonewbie learn walk --exam walk.policy       how well it follows velocities that change every 3 s",
            "  robonewbie learn walk --exam shipped           the same for the policy of the framework",
            "  robonewbie learn walk --exam fast              the same for the walk engine alone, WalkStyle.FAST; or standard"
        })
final class LearnCommand implements Callable<Integer> {

    @Mixin
    final HelpOption help = new HelpOption();

    @Parameters(
            paramLabel = "TASK",
            description = "walk, jog, run, Stand, KickTo, QuickGetUp, another task, or a class of yours.")
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

    @Option(
            names = "--seconds",
            paramLabel = "T",
            description = "Simulated length of a lesson in walk, jog and run (9).")
    private double seconds = 9;

    @Option(names = "--push", paramLabel = "N", description = "Newtons of the hardest pushes in walk, jog and run (6).")
    private double push = 6;

    @Option(
            names = "--option",
            paramLabel = "NAME=VALUE",
            description =
                    "What is different in the episodes of a task, such as noise=0.5 or push=10; docs/gym-protocol.md has all. In walk, jog and run forward=LOW..HIGH: the speeds straight ahead, in m/s; step=MILLISECONDS; tolerance=X: the error that leaves no reward, in m/s; slow=SHARE: how often a run is slowed down; types=FIRST..LAST: how the robots are built.")
    private List<String> options = List.of();

    @Option(
            names = "--inputs",
            paramLabel = "REGEX",
            description = "Names of what the network takes in a task (all that is observed but joints).")
    private String inputs = TaskCourse.USUAL_INPUTS;

    @Option(
            names = "--hidden",
            paramLabel = "N",
            description = "Hidden neurons of the network in a task; 0 for no hidden layer (16).")
    private int hidden = TaskCourse.USUAL_HIDDEN;

    @Mixin
    private final ClassPathOption classPath = new ClassPathOption();

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
            description =
                    "Do not learn, but examine: a policy, \"shipped\", \"none\", and for walks \"fast\" or \"standard\".")
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
            Course course = course();
            return exam == null ? learn(course) : examine(course, exam);
        } catch (IllegalArgumentException | UncheckedIOException wrong) {
            throw new CalledWronglyException(String.valueOf(wrong.getMessage()));
        }
    }

    private Course course() {
        Optional<WalkCourse> walk = WalkCourse.named(task);
        return walk.isPresent()
                ? walk.get().with(options)
                : TaskCourse.of(task, inputs, hidden, ProgramFinder.loaderOf(classPath.folders()));
    }

    private TrainingPlan plan() {
        return new TrainingPlan(seed, generations, pairs, spread, rate, seconds, push, options, threads);
    }

    private int learn(Course course) throws IOException {
        Path file = out == null ? Path.of(course.task() + ".policy") : out;
        PolicyTraining training = new PolicyTraining(course, plan(), file, history(file));
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

    private int examine(Course course, String what) {
        if (lessons < 1) {
            throw new CalledWronglyException("--lessons has to be greater than 0.");
        }
        TrainingPlan plan = plan();
        if (dash > 0) {
            return dash(walk(course, what));
        }
        LessonFigures figures = course instanceof WalkCourse walks
                ? Exam.walk(walks, walk(course, what), lessons, seconds, push, threads)
                : Exam.of(course, plan, lessons, policy(course, what));
        System.out.println(what + ", " + lessons + " lessons: " + figures);
        return ExitCode.OK;
    }

    private int dash(PolicyWalk walk) {
        List<WalkDash> dashes = Exam.dash(walk, dash, push, lessons, threads);
        dashes.forEach(System.out::println);
        System.out.printf(
                Locale.ROOT,
                "%d of %d without a fall; median %.3f m/s%n",
                dashes.stream().filter(one -> !one.fallen()).count(),
                lessons,
                dashes.stream().map(WalkDash::speed).sorted().toList().get(lessons / 2));
        return ExitCode.OK;
    }

    private static Policy policy(Course course, String what) {
        return switch (what) {
            case "shipped" -> PolicyFile.shipped(shippedName(course.task()));
            case "none" -> course.policy(List.of(), course.start(0));
            default -> PolicyFile.read(Path.of(what));
        };
    }

    /** The name of a shipped policy: {@code kick-to} for {@code KickTo}, {@code get-up} for {@code QuickGetUp}. */
    private static String shippedName(String task) {
        return task.replaceFirst("^Quick(?=[A-Z])", "")
                .replaceAll("(?<=[a-z])(?=[A-Z])", "-")
                .toLowerCase(Locale.ROOT);
    }

    private static PolicyWalk walk(Course course, String what) {
        return switch (what) {
            case "fast" -> new PolicyWalk(WalkStyle.FAST, WalkReflex.NONE);
            case "standard" -> new PolicyWalk(WalkStyle.STANDARD, WalkReflex.NONE);
            default -> new PolicyWalk(policy(course, what));
        };
    }
}
