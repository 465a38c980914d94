package org.robonewbie.exercises;

import java.util.List;
import java.util.Locale;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.motion.Keyframe;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.Posture;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.WorldState;

/**
 * Task: stop the left shoulder at 30° ± 1° from a random start angle. Commands take effect two cycles later, so a controller
 * that ignores the delay overshoots.
 */
final class StopAt30Task implements Task {

    private static final double GOAL_DEGREES = 30;
    private static final double TOLERANCE_DEGREES = 1;
    private static final double LATEST_SECONDS = 1.8;

    private double highest = Double.NEGATIVE_INFINITY;
    private double largestError;

    @Override
    public Scene scene(RandomSource random) {
        Posture low = Posture.ZERO.with(Joint.LEFT_SHOULDER_PITCH, random.between(-60, 0));
        return Scene.of(RobotStart.at(-1, 0).after(new Motion("low", List.of(new Keyframe(600, low)))));
    }

    @Override
    public void see(WorldState state) {
        double degrees = state.robot().degrees(Joint.LEFT_SHOULDER_PITCH);
        highest = Math.max(highest, degrees);
        if (state.seconds() > LATEST_SECONDS) {
            largestError = Math.max(largestError, Math.abs(degrees - GOAL_DEGREES));
        }
    }

    @Override
    public Score score() {
        String finding =
                String.format(Locale.ROOT, "highest angle %.2f°, at rest %.2f° away from 30°", highest, largestError);
        boolean stopped = largestError <= TOLERANCE_DEGREES;
        boolean overshot = highest > GOAL_DEGREES + TOLERANCE_DEGREES;
        if (stopped && !overshot) {
            return Score.passed(finding);
        }
        return Score.failed(
                stopped ? 5 : 5 - largestError,
                finding,
                overshot
                        ? "When the sensor reads 30, two more steps are under way: stop earlier, or slow down near"
                                + " the target."
                        : "The arm must be within 1° of 30° after 1.8 s and stay there: move it fast while it is far"
                                + " away and slowly when it is close.");
    }
}
