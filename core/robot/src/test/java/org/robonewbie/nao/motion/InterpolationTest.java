package org.robonewbie.nao.motion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.robonewbie.nao.Joint;

class InterpolationTest {

    private static final Joint JOINT = Joint.LEFT_KNEE_PITCH;
    private static final Posture START = Posture.ZERO;
    private static final Motion MOTION =
            new Motion("bend", List.of(keyframe(100, -10), keyframe(200, -40), keyframe(100, -20)));

    @ParameterizedTest
    @CsvSource({
        "-5, 0",
        "0, 0",
        "50, -5",
        "100, -10",
        "200, -25",
        "299, -39.85",
        "300, -40",
        "350, -30",
        "400, -20",
        "1000, -20"
    })
    void goesStraightFromKeyframeToKeyframe(double millis, double degrees) {
        Posture posture = new MotionCourse(START, MOTION, Interpolation.LINEAR).postureAt(millis);

        assertThat(posture.degrees(JOINT)).isCloseTo(degrees, within(1e-12));
        assertThat(posture.with(JOINT, 0)).isEqualTo(START);
    }

    @Test
    void endsExactlyAtTheTarget() {
        Motion motion = new Motion("bend", List.of(keyframe(60, 0.1)));
        Posture start = START.with(JOINT, -77.7);

        assertThat(Interpolation.LINEAR.degrees(new KeyframeInterval(start, motion, 0), JOINT, 1))
                .isEqualTo(0.1);
    }

    @Test
    void passesOverKeyframesWithoutTime() {
        Motion motion = new Motion("jump", List.of(keyframe(0, -10), keyframe(-20, -20), keyframe(100, -30)));
        MotionCourse course = new MotionCourse(START, motion, Interpolation.LINEAR);

        assertThat(course.postureAt(50).degrees(JOINT)).isEqualTo(-25);
        assertThat(course.postureAt(100).degrees(JOINT)).isEqualTo(-30);
    }

    @Test
    void staysWhereItIsWithoutKeyframes() {
        MotionCourse course = new MotionCourse(START, new Motion("none", List.of()), Interpolation.LINEAR);

        assertThat(course.postureAt(100)).isEqualTo(START);
    }

    @Test
    void showsTheNeighboursOfASection() {
        KeyframeInterval first = new KeyframeInterval(START, MOTION, 0);
        KeyframeInterval second = new KeyframeInterval(START, MOTION, 1);
        KeyframeInterval last = new KeyframeInterval(START, MOTION, 2);

        assertThat(List.of(first.before(), first.from(), first.to(), first.after()))
                .extracting(posture -> posture.degrees(JOINT))
                .containsExactly(0.0, 0.0, -10.0, -40.0);
        assertThat(List.of(second.before(), second.from(), second.to(), second.after()))
                .extracting(posture -> posture.degrees(JOINT))
                .containsExactly(0.0, -10.0, -40.0, -20.0);
        assertThat(List.of(last.before(), last.from(), last.to(), last.after()))
                .extracting(posture -> posture.degrees(JOINT))
                .containsExactly(-10.0, -40.0, -20.0, -20.0);
        assertThat(List.of(first.durationBeforeMillis(), first.durationMillis(), first.durationAfterMillis()))
                .containsExactly(0, 100, 200);
        assertThat(List.of(last.durationBeforeMillis(), last.durationMillis(), last.durationAfterMillis()))
                .containsExactly(200, 100, 0);
    }

    @Test
    void refusesSectionsThatDoNotExist() {
        assertThatThrownBy(() -> new KeyframeInterval(START, MOTION, 3))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("Keyframe 3 does not exist: motion bend has 3 keyframes, numbered from 0.");
    }

    @Test
    void letsAStudentWriteASpline() {
        MotionCourse course = new MotionCourse(START, MOTION, new Spline());

        double step = 0.001;
        for (double corner : new double[] {100, 300}) {
            double before = course.postureAt(corner).degrees(JOINT)
                    - course.postureAt(corner - step).degrees(JOINT);
            double after = course.postureAt(corner + step).degrees(JOINT)
                    - course.postureAt(corner).degrees(JOINT);
            assertThat(after).isCloseTo(before, within(1e-7));
        }
        assertThat(course.postureAt(100).degrees(JOINT)).isCloseTo(-10, within(1e-12));
        assertThat(course.postureAt(400).degrees(JOINT)).isEqualTo(-20);
    }

    /** A cubic Hermite curve whose speed at a keyframe is the mean speed of the ways before and after. */
    private static final class Spline implements Interpolation {

        @Override
        public double degrees(KeyframeInterval section, Joint joint, double fraction) {
            double before = section.before().degrees(joint);
            double from = section.from().degrees(joint);
            double to = section.to().degrees(joint);
            double after = section.after().degrees(joint);
            double duration = section.durationMillis();
            double startSpeed = (to - before) / (duration + section.durationBeforeMillis()) * duration;
            double endSpeed = (after - from) / (duration + section.durationAfterMillis()) * duration;
            double rest = 1 - fraction;
            return from * (1 + 2 * fraction) * rest * rest
                    + startSpeed * fraction * rest * rest
                    + to * (3 - 2 * fraction) * fraction * fraction
                    - endSpeed * fraction * fraction * rest;
        }
    }

    private static Keyframe keyframe(int millis, double degrees) {
        return new Keyframe(millis, START.with(JOINT, degrees));
    }
}
