package org.robonewbie.learning.measure;

import java.util.List;
import java.util.function.ToDoubleFunction;
import org.robonewbie.agent.walk.WalkEngine;
import org.robonewbie.agent.walk.WalkStyle;
import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.learning.trial.Course;
import org.robonewbie.learning.trial.WalkTrial;
import org.robonewbie.nao.motion.PostureFollower;

/** Checks of the walk engine. */
final class EngineChecks {

    private static final String STANCE = "stance, reached from a posture beside it";
    private static final double PUSH_NEWTONS = 3;
    private static final double MOST_SECONDS = 60;
    private static final double STOP_SECONDS = 3;
    private static final WalkStyle STYLE = WalkStyle.STANDARD;
    private static final WalkVelocity AHEAD = new WalkVelocity(STYLE.most().forward(), 0, 0);

    private EngineChecks() {}

    static List<MotionCheck> all() {
        return List.of(
                way("walk engine, forward", AHEAD, 5, Course::forward),
                straight(),
                way("walk engine, backward", new WalkVelocity(-STYLE.backward(), 0, 0), 2, course -> -course.forward()),
                way("walk engine, to the left", new WalkVelocity(0, STYLE.most().left(), 0), 2, Course::left),
                way(
                        "walk engine, to the right",
                        new WalkVelocity(0, -STYLE.most().left(), 0),
                        2,
                        course -> -course.left()),
                turn(),
                erratic());
    }

    private static MotionCheck way(String name, WalkVelocity velocity, double metres, ToDoubleFunction<Course> way) {
        String rule = "walks " + Math.round(metres) + " m, stops, ends in the stance";
        return new MotionCheck(name, STANCE, rule, "m/s over the way", seed -> {
            Course course = new Course(seed, PUSH_NEWTONS);
            WalkEngine engine = walked(course, velocity, way, metres);
            double speed = way.applyAsDouble(course) / course.watch().seconds();
            return new Outcome(endsInStance(course, engine) && speed > 0, speed);
        });
    }

    private static MotionCheck straight() {
        return new MotionCheck(
                "walk engine, straight", STANCE, "turns by at most 10° on 5 m", "degrees to either side", seed -> {
                    Course course = new Course(seed, PUSH_NEWTONS);
                    walked(course, AHEAD, Course::forward, 5);
                    double turn = Math.abs(course.turnedDegrees());
                    return new Outcome(!course.watch().hasFallen() && turn <= 10, turn);
                });
    }

    private static MotionCheck turn() {
        WalkVelocity velocity = new WalkVelocity(0, 0, STYLE.most().turn());
        return new MotionCheck("walk engine, turn", STANCE, "turns once around, ends in the stance", "°/s", seed -> {
            Course course = new Course(seed, PUSH_NEWTONS);
            WalkEngine engine = walked(course, velocity, Course::turnedDegrees, 360);
            double speed = course.turnedDegrees() / course.watch().seconds();
            return new Outcome(endsInStance(course, engine), speed);
        });
    }

    private static MotionCheck erratic() {
        return new MotionCheck(
                "walk engine, erratic",
                STANCE,
                "stands after 30 s of velocities at random, a new one every 0.7 s in the mean",
                "s on its feet",
                seed -> {
                    WalkTrial trial = WalkTrial.erratic(STYLE, 30, seed, PUSH_NEWTONS);
                    return new Outcome(trial.stood(), trial.seconds());
                });
    }

    private static WalkEngine walked(
            Course course, WalkVelocity velocity, ToDoubleFunction<Course> way, double length) {
        WalkEngine engine = new WalkEngine(STYLE);
        PostureFollower follower = course.robot().follower();
        engine.towards(velocity);
        boolean up = true;
        while (up && way.applyAsDouble(course) < length && course.watch().seconds() < MOST_SECONDS) {
            up = course.walk(engine, follower);
        }
        engine.towards(WalkVelocity.ZERO);
        return engine;
    }

    private static boolean endsInStance(Course course, WalkEngine engine) {
        PostureFollower follower = course.robot().follower();
        double end = course.watch().seconds() + STOP_SECONDS;
        while (!engine.isStanding() && course.watch().seconds() < end && course.walk(engine, follower)) {
            // until it has stopped
        }
        return course.endsInStance();
    }
}
