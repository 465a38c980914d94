package org.robonewbie.learning.policy;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robonewbie.agent.policy.Network;
import org.robonewbie.agent.policy.Policy;
import org.robonewbie.agent.walk.FastWalk;
import org.robonewbie.agent.walk.PolicyWalk;
import org.robonewbie.agent.walk.ResidualPolicy;
import org.robonewbie.agent.walk.WalkStyle;
import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.trial.Trial;

/**
 * What is learned in lessons: to follow velocities that change every 3 s. What is changed are the coordinates of a gait and the
 * weights of a network that corrects it.
 *
 * @param task its name
 * @param most the largest speeds
 * @param backward the largest speed backward, metres per second
 * @param stepMillis time of one step
 * @param commands what kinds of velocities are commanded
 * @param leastAhead which part of the largest speed forward is commanded at least on the way straight ahead
 * @param slowShare which part of the later commands of a run slows it down
 * @param toleratedMetresPerSecond which error of the velocity leaves nothing of the reward
 * @param builds how the robots are built that take the lessons, one after the other
 */
public record WalkCourse(
        String task,
        WalkVelocity most,
        double backward,
        int stepMillis,
        WalkCommands commands,
        double leastAhead,
        double slowShare,
        double toleratedMetresPerSecond,
        List<RobotType> builds)
        implements Course {

    private static final List<RobotType> USUAL = List.of(RobotType.TYPE_0);

    /** Walks into any direction: forward with up to 0.8 m/s. */
    public static final WalkCourse WALK =
            new WalkCourse("walk", new WalkVelocity(0.8, 0.2, 90), 0.3, 200, WalkCommands.ANYWHERE, 0.3, 0, 0.3, USUAL);

    /** Runs ahead with 0.9 to 1.3 m/s, with short steps, bends a little to both sides, slows down and stops. */
    public static final WalkCourse RUN =
            new WalkCourse("run", new WalkVelocity(1.3, 0.2, 60), 0.3, 140, WalkCommands.AHEAD, 0.7, 0.3, 0.9, USUAL);

    /** Jogs ahead with 0.6 to 1.1 m/s, straight or in bends, slower or not at all as a player needs it. Turns cost little speed. */
    public static final WalkCourse JOG =
            new WalkCourse("jog", new WalkVelocity(1.1, 0.2, 300), 0.3, 140, WalkCommands.BENDS, 0.6, 0.3, 0.5, USUAL);

    /** Copies the list. */
    public WalkCourse {
        builds = List.copyOf(builds);
    }

    /** In which part of the lessons of a training the command stays the same. */
    private static final double LONG_SHARE = 0.4;

    private static final int HIDDEN = 16;
    private static final int[] LAYERS = {ResidualPolicy.INPUTS.size(), HIDDEN, ResidualPolicy.OUTPUTS.size()};
    private static final int WEIGHTS = Network.size(LAYERS);
    private static final int GAIT = FastWalk.PARAMETERS;
    private static final double GAIT_UNIT = 3;
    private static final double USUAL_EASING = 4;

    /**
     * Looks a course up.
     *
     * @param task {@code walk}, {@code run} or {@code jog}
     * @return the course; empty if there is none of this name
     */
    public static Optional<WalkCourse> named(String task) {
        return Stream.of(WALK, RUN, JOG)
                .filter(course -> course.task().equals(task))
                .findAny();
    }

    /**
     * Makes the same course with other lessons.
     *
     * @param options such as {@code forward=0.7..1.1}, see {@link WalkOption}
     * @return the course
     * @throws IllegalArgumentException if there is another option, or if a value is not possible
     */
    public WalkCourse with(List<String> options) {
        WalkCourse course = this;
        for (String option : options) {
            course = WalkOption.change(course, option);
        }
        return course;
    }

    WalkCourse withForward(double low, double high) {
        WalkVelocity faster = new WalkVelocity(high, most.left(), most.turn());
        return new WalkCourse(
                task, faster, backward, stepMillis, commands, low / high, slowShare, toleratedMetresPerSecond, builds);
    }

    WalkCourse withStepMillis(int millis) {
        return new WalkCourse(
                task, most, backward, millis, commands, leastAhead, slowShare, toleratedMetresPerSecond, builds);
    }

    WalkCourse withSlowShare(double share) {
        return new WalkCourse(
                task, most, backward, stepMillis, commands, leastAhead, share, toleratedMetresPerSecond, builds);
    }

    WalkCourse withToleratedMetresPerSecond(double metresPerSecond) {
        return new WalkCourse(
                task, most, backward, stepMillis, commands, leastAhead, slowShare, metresPerSecond, builds);
    }

    WalkCourse withBuilds(List<RobotType> others) {
        return new WalkCourse(
                task, most, backward, stepMillis, commands, leastAhead, slowShare, toleratedMetresPerSecond, others);
    }

    @Override
    public String words(TrainingPlan plan) {
        String options =
                plan.options().stream().map(option -> " --option " + option).collect(Collectors.joining());
        return plan.words() + " --seconds " + plan.seconds() + " --push " + plan.newtons() + options;
    }

    @Override
    public Classroom open(TrainingPlan plan) {
        List<Trial> rooms = builds.stream().map(WalkLesson::room).toList();
        int cycles = (int) Math.round(plan.seconds() / Cycle.SECONDS);
        return new Classroom() {

            @Override
            public LessonFigures give(long seed, double... numbers) {
                return give(walk(numbers), seed, LONG_SHARE);
            }

            @Override
            public LessonFigures examine(long seed, Policy policy) {
                return give(new PolicyWalk(policy), seed, 0);
            }

            private LessonFigures give(PolicyWalk walk, long seed, double longShare) {
                Trial room = rooms.get((int) Math.floorMod(seed, (long) rooms.size()));
                return WalkLesson.give(room, WalkCourse.this, walk, seed, plan.newtons(), longShare, cycles);
            }

            @Override
            public void close() {
                rooms.forEach(Trial::close);
            }
        };
    }

    /** The standard gait, and a network that corrects nothing yet. */
    @Override
    public double[] start(long seed) {
        Random random = new Random(seed);
        random.nextLong();
        double[] start = Arrays.copyOf(WalkStyle.coordinates(), GAIT + WEIGHTS);
        start[GAIT - 2] = USUAL_EASING;
        int hidden = Network.size(LAYERS[0], LAYERS[1]);
        for (int i = 0; i < hidden; i++) {
            start[GAIT + i] = random.nextGaussian() / Math.sqrt(LAYERS[0]);
        }
        return start;
    }

    @Override
    public double[] start(Policy policy) {
        double[] start = Arrays.copyOf(policy.numbers("gait", GAIT), GAIT + WEIGHTS);
        System.arraycopy(policy.network().numbers(), 0, start, GAIT, WEIGHTS);
        return start;
    }

    @Override
    public double[] units() {
        double[] units = new double[GAIT + WEIGHTS];
        Arrays.fill(units, 1);
        Arrays.fill(units, 0, GAIT, GAIT_UNIT);
        return units;
    }

    /** The walk of a candidate. */
    PolicyWalk walk(double... numbers) {
        WalkStyle style =
                FastWalk.style(stepMillis, Arrays.copyOf(numbers, GAIT)).withMost(most, backward);
        return new PolicyWalk(style, new ResidualPolicy(network(numbers)));
    }

    @Override
    public Policy policy(List<String> about, double... numbers) {
        return PolicyWalk.policy(
                task, about, stepMillis, most, backward, Arrays.copyOf(numbers, GAIT), network(numbers));
    }

    private static Network network(double... numbers) {
        return Network.of(LAYERS, Arrays.copyOfRange(numbers, GAIT, GAIT + WEIGHTS));
    }

    /** Draws a velocity for a whole lesson: in half of them straight ahead as fast as possible. */
    WalkVelocity longCommand(Random random) {
        return random.nextDouble() < 0.5 ? new WalkVelocity(most.forward(), 0, 0) : commands.first(this, random);
    }
}
