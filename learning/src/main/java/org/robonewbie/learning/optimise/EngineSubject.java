package org.robonewbie.learning.optimise;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.robonewbie.agent.walk.WalkEngine;
import org.robonewbie.agent.walk.WalkParameter;
import org.robonewbie.agent.walk.WalkStyle;
import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.learning.trial.Course;
import org.robonewbie.learning.trial.WalkTrial;
import org.robonewbie.nao.file.AtomicFile;
import org.robonewbie.nao.motion.PostureFollower;

/** The numbers of the walk engine: it walks straight on as fast as it can, and must also stand what makes no sense. */
public final class EngineSubject implements Subject {

    /** What the walk engine is called on the command line. */
    public static final String NAME = "walk-engine";

    private static final double SIZE = 0.5;
    private static final double SECONDS = 7;
    private static final double ERRATIC_SECONDS = 5;
    private static final double SECONDS_TO_STOP = 3;
    private static final double PUSH_NEWTONS = 5;

    private final Objective objective;

    /**
     * Takes the walk engine as subject.
     *
     * @param objective what is measured
     */
    public EngineSubject(Objective objective) {
        this.objective = objective;
    }

    @Override
    public String name() {
        return NAME;
    }

    @Override
    public int dimension() {
        return WalkStyle.PARAMETERS;
    }

    @Override
    public List<SubjectNumber> numbers(double[] coordinates) {
        double[] numbers = shifted(coordinates);
        return IntStream.range(0, numbers.length)
                .mapToObj(i -> new SubjectNumber(WalkParameter.values()[i].description(), "", numbers[i], SIZE))
                .toList();
    }

    @Override
    public String fingerprint() {
        return Integer.toHexString(Arrays.hashCode(WalkStyle.coordinates()));
    }

    @Override
    public Attempt attempt(double[] coordinates, long seed) {
        WalkStyle style = style(coordinates);
        MeasuringEye eye = new MeasuringEye(objective.measure().get());
        Course course = new Course(seed, PUSH_NEWTONS, eye);
        boolean stood = walk(course, style, eye);
        boolean alwaysStood = stood
                && WalkTrial.erratic(style, ERRATIC_SECONDS, seed, PUSH_NEWTONS).stood();
        double aside =
                Math.abs(course.turnedDegrees()) / 90 + 0.001 * course.watch().meanRocking();
        return new Attempt(eye.value(), alwaysStood ? 1 : 0, aside);
    }

    @Override
    public void save(double[] coordinates, Map<String, String> facts, Path file) throws IOException {
        String text = facts.entrySet().stream()
                .map(fact -> "// " + fact.getKey() + ": " + fact.getValue() + "\n")
                .collect(Collectors.joining("", "", text(shifted(coordinates)) + "\n"));
        AtomicFile.write(file, text);
    }

    private static boolean walk(Course course, WalkStyle style, MeasuringEye eye) {
        WalkEngine engine = new WalkEngine(style);
        PostureFollower follower = course.robot().follower();
        engine.towards(new WalkVelocity(style.most().forward(), 0, 0));
        while (course.watch().seconds() < SECONDS && course.walk(engine, follower)) {
            // straight on
        }
        eye.close();
        engine.towards(WalkVelocity.ZERO);
        double end = course.watch().seconds() + SECONDS_TO_STOP;
        while (!engine.isStanding() && course.watch().seconds() < end && course.walk(engine, follower)) {
            // until it stands
        }
        return course.endsInStance();
    }

    private static WalkStyle style(double[] coordinates) {
        return WalkStyle.standard(shifted(coordinates));
    }

    private static double[] shifted(double[] coordinates) {
        double[] numbers = WalkStyle.coordinates();
        for (int i = 0; i < coordinates.length; i++) {
            numbers[i] = Math.round(100 * (numbers[i] + SIZE * coordinates[i])) / 100.0;
        }
        return numbers;
    }

    private static String text(double[] numbers) {
        return Arrays.stream(numbers)
                .mapToObj(x -> String.format(Locale.ROOT, "%.2f", x))
                .collect(Collectors.joining(", "));
    }
}
