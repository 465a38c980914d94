package org.robonewbie.exercises;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.function.ToDoubleFunction;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.walk.WalkStyle;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.trial.Controller;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;

/**
 * Detects the built-in fast walk by the mean and amplitude of each leg joint's angle. A walk that is more similar to the fast
 * walk than to the standard walk is considered to be derived from it.
 */
final class RecognisedGait {

    private static final double STARTING_SECONDS = 4;
    private static final double SECONDS = 8;
    private static final Set<Joint> LEGS = EnumSet.range(Joint.LEFT_HIP_YAW_PITCH, Joint.RIGHT_FOOT_ROLL);

    private final List<BodyState> seen = new ArrayList<>();

    /** Adds a sample. Call this in each cycle of steady walking. */
    void see(BodyState robot) {
        seen.add(robot);
    }

    /** Returns whether the walk is more similar to the fast walk than to the standard walk. */
    boolean isFastWalk() {
        return !seen.isEmpty() && distance(seen, Known.FAST) < distance(seen, Known.STANDARD);
    }

    /** States of a robot walking straight ahead with each of the built-in walks. */
    private static final class Known {
        static final List<BodyState> STANDARD = walked(WalkStyle.STANDARD);
        static final List<BodyState> FAST = walked(WalkStyle.FAST);
    }

    private static List<BodyState> walked(WalkStyle style) {
        Scene scene =
                Scene.of(RobotStart.at(-5, 0).after("stand")).withBall(5.5, 3.7).withoutNoise();
        List<BodyState> states = new ArrayList<>();
        try (Trial trial = Trial.direct(scene, 1, Controller.ofAgent(new Straight(style)))) {
            while (trial.seconds() < SECONDS) {
                BodyState robot = trial.step().robot();
                if (trial.seconds() > STARTING_SECONDS) {
                    states.add(robot);
                }
            }
        }
        return states;
    }

    private static final class Straight extends Agent {

        Straight(WalkStyle style) {
            walk.setStyle(style);
        }

        @Override
        protected void think() {
            walk.towards(1, 0, 0);
        }
    }

    private static double distance(List<BodyState> some, List<BodyState> others) {
        double square = 0;
        for (Joint joint : LEGS) {
            ToDoubleFunction<BodyState> angle = robot -> robot.degrees(joint);
            double mean = mean(some, angle) - mean(others, angle);
            double spread = spread(some, angle) - spread(others, angle);
            square += mean * mean + spread * spread;
        }
        return square;
    }

    private static double mean(List<BodyState> states, ToDoubleFunction<BodyState> angle) {
        return states.stream().mapToDouble(angle).average().orElseThrow();
    }

    private static double spread(List<BodyState> states, ToDoubleFunction<BodyState> angle) {
        double mean = mean(states, angle);
        return Math.sqrt(mean(states, state -> Math.pow(angle.applyAsDouble(state) - mean, 2)));
    }
}
