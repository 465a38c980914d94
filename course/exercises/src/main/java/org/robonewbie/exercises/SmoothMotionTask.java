package org.robonewbie.exercises;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Joint;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.WorldState;

/**
 * Task: play a motion of the left shoulder through its keyframes without the sudden changes of speed that linear interpolation
 * causes at each keyframe.
 */
final class SmoothMotionTask implements Task {

    private static final double[] SECONDS = {0.4, 0.8, 1.4, 1.8};
    private static final double[] DEGREES = {60, -30, 45, 0};
    private static final double TOLERANCE_DEGREES = 5;
    private static final int CYCLES_AROUND = 3;
    private static final double SMOOTH = 150;

    private final List<Double> angles = new ArrayList<>();

    @Override
    public Scene scene(RandomSource random) {
        return Scene.of(RobotStart.at(-1, 0));
    }

    @Override
    public void see(WorldState state) {
        angles.add(state.robot().degrees(Joint.LEFT_SHOULDER_PITCH));
    }

    @Override
    public Score score() {
        double missed = 0;
        for (int i = 0; i < SECONDS.length; i++) {
            missed = Math.max(missed, nearest(SECONDS[i], DEGREES[i]));
        }
        double jerk = 0;
        for (int i = 2; i < angles.size(); i++) {
            double change = angles.get(i) - 2 * angles.get(i - 1) + angles.get(i - 2);
            jerk = Math.max(jerk, Math.abs(change) / Cycle.SECONDS);
        }
        String finding = String.format(
                Locale.ROOT, "keyframes missed by %.1f°, largest speed change %.0f °/s per cycle", missed, jerk);
        boolean through = missed <= TOLERANCE_DEGREES;
        if (through && jerk <= SMOOTH) {
            return Score.passed(finding);
        }
        return Score.failed(
                through ? 3 : 0,
                finding,
                through
                        ? "Write an Interpolation whose slope at each keyframe is the same on both sides; a"
                                + " difference of up to 150 °/s is allowed."
                        : "The curve must pass through all keyframes: fraction 0 gives section.from(),"
                                + " fraction 1 section.to().");
    }

    /**
     * Returns the smallest deviation in degrees from a keyframe's angle around its time, allowing for the two cycles
     * that it takes for a command to take effect.
     */
    private double nearest(double seconds, double degrees) {
        int expected = (int) Math.round(seconds / Cycle.SECONDS) + 2;
        double best = Double.POSITIVE_INFINITY;
        for (int i = expected - CYCLES_AROUND; i <= expected + CYCLES_AROUND; i++) {
            best = Math.min(best, Math.abs(angles.get(i) - degrees));
        }
        return best;
    }
}
