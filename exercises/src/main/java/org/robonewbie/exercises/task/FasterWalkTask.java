package org.robonewbie.exercises.task;

import java.util.Locale;
import org.robonewbie.exercises.Score;
import org.robonewbie.exercises.Task;
import org.robonewbie.trial.Chance;
import org.robonewbie.trial.Moment;
import org.robonewbie.trial.Place;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;

/**
 * Walk as far as possible in 10 seconds.
 */
public final class FasterWalkTask implements Task {

    private static final Place STUDENT = new Place(-5, 0, 0);
    private static final double FAR_METRES = 4;
    private static final double ASIDE_METRES = 1;

    private double metres;
    private double aside;
    private boolean fallen;

    /** Creates the task of one trial. */
    public FasterWalkTask() {}

    @Override
    public Scene scene(Chance chance) {
        return Scene.of(RobotStart.at(STUDENT).after("stand")).withBall(4, 3.5);
    }

    @Override
    public void see(Moment moment) {
        metres = moment.robot().position().x() - STUDENT.x();
        aside = Math.max(aside, Math.abs(moment.robot().position().y()));
        fallen |= moment.robot().isFallen();
    }

    @Override
    public boolean isDecided() {
        return fallen;
    }

    @Override
    public Score score() {
        String finding = String.format(
                Locale.ROOT, "%.2f m in 10 s, at most %.2f m aside%s", metres, aside, fallen ? ", then a fall" : "");
        if (fallen) {
            return Score.failed(
                    metres, finding, "Too fast: change one parameter at a time and try each several times.");
        }
        return metres >= FAR_METRES && aside <= ASIDE_METRES
                ? Score.passed((int) Math.round(7 + 2 * (metres - FAR_METRES)), finding, "")
                : Score.failed(
                        2 * metres,
                        finding,
                        "Let a program try many values, keep the best, and vary it again; the points are what it climbs.");
    }
}
