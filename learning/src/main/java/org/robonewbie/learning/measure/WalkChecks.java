package org.robonewbie.learning.measure;

import java.util.List;
import org.robonewbie.learning.trial.Course;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.file.ShippedMotions;

/** Checks of the motions that carry the robot over the pitch. */
final class WalkChecks {

    private static final String STANCE = "stance, reached from a posture beside it";
    private static final double WAY = 5;
    private static final double MOST_SECONDS = 120;
    private static final double PUSH_NEWTONS = 3;

    private WalkChecks() {}

    static List<MotionCheck> all() {
        return List.of(
                walk("walk-forward"),
                straight("walk-forward"),
                walk("walk-forward-fast"),
                straight("walk-forward-fast"),
                turn("turn-left", 1),
                turn("turn-right", -1),
                turn("turn-left-small", 1),
                turn("turn-right-small", -1),
                sideStep("side-step-left", 1),
                sideStep("side-step-right", -1),
                onTheSpot("stand"),
                onTheSpot("wave"),
                onTheSpot("bow"),
                onTheSpot("dance"));
    }

    private static MotionCheck walk(String name) {
        return new MotionCheck(name, STANCE, "walks 5 m, stops, ends in the stance", "m/s over the 5 m", seed -> {
            Course course = new Course(seed, PUSH_NEWTONS);
            walkFiveMetres(course, name);
            double speed = course.forward() / course.watch().seconds();
            course.play(ShippedMotions.motion("stop-walking"));
            return new Outcome(course.endsInStance(), speed);
        });
    }

    private static MotionCheck straight(String name) {
        return new MotionCheck(
                name + ", straight", STANCE, "turns by at most 10° on 5 m", "degrees to either side", seed -> {
                    Course course = new Course(seed, PUSH_NEWTONS);
                    walkFiveMetres(course, name);
                    double turn = Math.abs(course.turnedDegrees());
                    return new Outcome(!course.watch().hasFallen() && turn <= 10, turn);
                });
    }

    private static void walkFiveMetres(Course course, String name) {
        course.play(ShippedMotions.motion("start-walking"));
        Motion walk = ShippedMotions.motion(name);
        while (course.forward() < WAY && isInTime(course) && course.play(walk)) {
            // one cycle of two steps after the other
        }
    }

    private static boolean isInTime(Course course) {
        return course.watch().seconds() < MOST_SECONDS;
    }

    private static MotionCheck turn(String name, int sign) {
        return new MotionCheck(name, STANCE, "turns once around, ends in the stance", "degrees each time", seed -> {
            Course course = new Course(seed, PUSH_NEWTONS);
            Motion turn = ShippedMotions.motion(name);
            int times = 0;
            while (sign * course.turnedDegrees() < 360 && isInTime(course) && course.play(turn)) {
                times++;
            }
            return new Outcome(course.endsInStance(), Math.abs(course.turnedDegrees()) / Math.max(1, times));
        });
    }

    private static MotionCheck sideStep(String name, int sign) {
        return new MotionCheck(name, STANCE, "ends in the stance after five times", "m each time", seed -> {
            Course course = new Course(seed, PUSH_NEWTONS);
            playFiveTimes(course, name);
            return new Outcome(course.endsInStance() && sign * course.left() > 0, sign * course.left() / 5);
        });
    }

    private static MotionCheck onTheSpot(String name) {
        return new MotionCheck(name, STANCE, "ends in the stance after five times", "s each time", seed -> {
            Course course = new Course(seed, PUSH_NEWTONS);
            playFiveTimes(course, name);
            double seconds = course.watch().seconds() / 5;
            return new Outcome(course.endsInStance(), seconds);
        });
    }

    private static void playFiveTimes(Course course, String name) {
        for (int i = 0; i < 5; i++) {
            course.play(ShippedMotions.motion(name));
        }
    }
}
