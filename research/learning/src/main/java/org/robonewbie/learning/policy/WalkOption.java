package org.robonewbie.learning.policy;

import java.util.Arrays;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.robonewbie.nao.model.RobotType;

/** What can be different in lessons of walking; each is written {@code name=value}. */
public enum WalkOption {
    /** The speeds straight ahead, metres per second. */
    FORWARD(
            "forward=LOW..HIGH, such as forward=0.7..1.1, with up to 3 m/s",
            "(\\d(?:\\.\\d+)?)\\.\\.(\\d(?:\\.\\d+)?)") {

        @Override
        boolean isPossible(double low, double high) {
            return low > 0 && low <= high && high <= FASTEST;
        }

        @Override
        WalkCourse changed(WalkCourse course, double low, double high) {
            return course.withForward(low, high);
        }
    },
    /** Time of one step, milliseconds. */
    STEP("step=MILLISECONDS, a multiple of 20", "(\\d+)()") {

        @Override
        boolean isPossible(double millis, double none) {
            return millis > 0 && millis % 20 == 0;
        }

        @Override
        WalkCourse changed(WalkCourse course, double millis, double none) {
            return course.withStepMillis((int) millis);
        }
    },
    /** Which part of the later commands of a run slows it down. */
    SLOW("slow=SHARE, 0 to 1", "(\\d(?:\\.\\d+)?)()") {

        @Override
        boolean isPossible(double share, double none) {
            return share <= 1;
        }

        @Override
        WalkCourse changed(WalkCourse course, double share, double none) {
            return course.withSlowShare(share);
        }
    },
    /** Which error of the velocity leaves nothing of the reward, metres per second. */
    TOLERANCE("tolerance=X, in m/s", "(\\d(?:\\.\\d+)?)()") {

        @Override
        boolean isPossible(double metresPerSecond, double none) {
            return metresPerSecond > 0;
        }

        @Override
        WalkCourse changed(WalkCourse course, double metresPerSecond, double none) {
            return course.withToleratedMetresPerSecond(metresPerSecond);
        }
    },
    /** How the robots are built: each lesson has another type. */
    TYPES("types=FIRST..LAST, 0 to 4, such as types=0..4", "(\\d)\\.\\.(\\d)") {

        @Override
        boolean isPossible(double first, double last) {
            return first <= last && last < RobotType.values().length;
        }

        @Override
        WalkCourse changed(WalkCourse course, double first, double last) {
            return course.withBuilds(List.of(RobotType.values()).subList((int) first, (int) last + 1));
        }
    };

    private static final double FASTEST = 3;

    private final String words;
    private final Pattern pattern;

    WalkOption(String words, String value) {
        this.words = words;
        this.pattern = Pattern.compile(words.replaceAll("=.*", "=") + value);
    }

    /** Whether a value is possible; only a range has a second one. */
    abstract boolean isPossible(double first, double second);

    /** Changes a course. */
    abstract WalkCourse changed(WalkCourse course, double first, double second);

    /**
     * Changes a course.
     *
     * @throws IllegalArgumentException if there is no such option, or if its value is not possible
     */
    static WalkCourse change(WalkCourse course, String text) {
        for (WalkOption option : values()) {
            Matcher matcher = option.pattern.matcher(text);
            if (matcher.matches()) {
                return option.change(course, text, number(matcher.group(1)), number(matcher.group(2)));
            }
        }
        throw new IllegalArgumentException("Lessons in " + course.task() + " have no option " + text + ". There are "
                + Arrays.stream(values()).map(option -> option.words).collect(Collectors.joining("; ")) + ".");
    }

    private WalkCourse change(WalkCourse course, String text, double first, double second) {
        if (!isPossible(first, second)) {
            throw new IllegalArgumentException("Lessons take " + words + "; " + text + " is not possible.");
        }
        return changed(course, first, second);
    }

    private static double number(String text) {
        return text.isEmpty() ? 0 : Double.parseDouble(text);
    }
}
