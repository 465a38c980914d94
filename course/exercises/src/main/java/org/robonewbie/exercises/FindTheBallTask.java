package org.robonewbie.exercises;

import java.util.Locale;
import org.robonewbie.trial.Chance;
import org.robonewbie.trial.Moment;
import org.robonewbie.trial.Place;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.measure.Held;

/**
 * Look for a ball that lies out of sight, and face it for a second.
 */
final class FindTheBallTask implements Task {

    private static final Place STUDENT = new Place(-0.5, 0, 30);
    private static final double FACING_DEGREES = 10;
    private static final double HELD_SECONDS = 1;
    private static final double LIMIT_SECONDS = 8;
    private static final double QUICK_SECONDS = 5.5;

    private final Held facing =
            new Held(HELD_SECONDS, moment -> Math.abs(moment.place().bearing(moment.ball())) <= FACING_DEGREES);
    private double bearing;

    @Override
    public Scene scene(Chance chance) {
        double side = chance.isSeedOdd() ? 1 : -1;
        return Scene.of(RobotStart.at(STUDENT).after("stand"))
                .withBall(STUDENT.point(chance.between(1, 2.5), side * chance.between(100, 150), 0));
    }

    @Override
    public void see(Moment moment) {
        bearing = moment.place().bearing(moment.ball());
        facing.see(moment);
    }

    @Override
    public boolean isDecided() {
        return facing.isDecided();
    }

    @Override
    public Score score() {
        double foundSeconds = facing.value();
        if (facing.isDecided() && foundSeconds <= LIMIT_SECONDS) {
            int points = (int) Math.round(10 - 2 * Math.max(0, foundSeconds - QUICK_SECONDS));
            return Score.passed(
                    points,
                    String.format(Locale.ROOT, "faced the ball after %.1f s", foundSeconds),
                    points < 10
                            ? "The head is quicker than the legs, and the shorter way round is known once it is seen."
                            : "");
        }
        return Score.failed(
                2,
                String.format(Locale.ROOT, "the ball is still %.0f° aside", bearing),
                "Turn the head with lookAround.look() while the feet turn, and go on until the bearing is within 10°.");
    }
}
