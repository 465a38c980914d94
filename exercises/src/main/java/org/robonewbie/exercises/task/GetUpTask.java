package org.robonewbie.exercises.task;

import java.util.Locale;
import org.robonewbie.exercises.Score;
import org.robonewbie.exercises.Task;
import org.robonewbie.trial.Chance;
import org.robonewbie.trial.Moment;
import org.robonewbie.trial.Place;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.measure.Held;

/**
 * Get up: the robot lies on its back with odd seeds and on its front with even ones.
 */
public final class GetUpTask implements Task {

    private static final double HELD_SECONDS = 1;
    private static final double LIMIT_SECONDS = 12;
    private static final double QUICK_SECONDS = 7;

    private final Held up = new Held(HELD_SECONDS, moment -> moment.robot().isStanding());
    private boolean onBack;

    /** Creates the task of one trial. */
    public GetUpTask() {}

    @Override
    public Scene scene(Chance chance) {
        onBack = chance.isSeedOdd();
        return Scene.of(RobotStart.at(new Place(-1, 0, chance.between(-180, 180)))
                .after("stand", onBack ? "fall-back" : "fall-forward"));
    }

    @Override
    public void see(Moment moment) {
        up.see(moment);
    }

    @Override
    public boolean isDecided() {
        return up.isDecided();
    }

    @Override
    public Score score() {
        String from = onBack ? "from the back" : "from the front";
        double upSeconds = up.value();
        if (up.isDecided() && upSeconds <= LIMIT_SECONDS) {
            int points = (int) Math.round(10 - Math.max(0, upSeconds - QUICK_SECONDS));
            return Score.passed(points, String.format(Locale.ROOT, "stood %s after %.1f s", from, upSeconds), "");
        }
        return Score.failed(
                1,
                "did not get up " + from,
                "nao.getBodyPosition() tells how the robot lies; each way of lying needs a motion of its own.");
    }
}
