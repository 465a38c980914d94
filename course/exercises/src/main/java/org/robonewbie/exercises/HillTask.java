package org.robonewbie.exercises;

import java.util.Locale;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.simulator.landscape.Landscape;
import org.robonewbie.simulator.landscape.Thing;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.WorldState;
import org.robonewbie.trial.measure.SustainedCondition;

/** Task: walk up a slope and stand still at the top. */
final class HillTask implements Task {

    private static final Thing TOP = Landscape.SLOPE.things().get(1);
    private static final double HELD_SECONDS = 3;
    private static final double STILL_METRES = 0.06;
    private static final double MIN_TORSO_METRES = 0.25;

    private final SustainedCondition standing = new SustainedCondition(HELD_SECONDS, this::isStandingOnTop);
    private Pose2d anchor = new Pose2d(0, 0, 0);
    private double highest;
    private boolean fallen;

    @Override
    public Scene scene(RandomSource random) {
        Pose2d start = new Pose2d(random.between(-5.1, -4.7), random.between(-0.8, 0.8), random.between(-40, 40));
        return Scene.of(RobotStart.at(start).after("stand"))
                .withLandscape(Landscape.SLOPE)
                .withBall(0, random.between(-1, 1));
    }

    @Override
    public void see(WorldState state) {
        fallen |= state.robot().isFallen();
        if (isOverTop(state)) {
            highest = Math.max(highest, state.robot().position().z() - MIN_TORSO_METRES);
        }
        standing.see(state);
    }

    private static boolean isOverTop(WorldState state) {
        Pose2d place = state.place();
        return Math.abs(place.x() - TOP.centre().x()) < TOP.size().x() / 2
                && Math.abs(place.y() - TOP.centre().y()) < TOP.size().y() / 2;
    }

    /**
     * Returns whether the robot is standing still at the top: it must stay near an anchor point, which is moved to the
     * robot whenever the robot has left it.
     */
    private boolean isStandingOnTop(WorldState state) {
        Pose2d place = state.place();
        boolean still = place.distance(new Vector3(anchor.x(), anchor.y(), 0)) <= STILL_METRES;
        anchor = still ? anchor : place;
        boolean high = state.robot().position().z() > TOP.size().z() + MIN_TORSO_METRES;
        return still && high && isOverTop(state) && !state.robot().isFallen();
    }

    @Override
    public boolean isDecided() {
        return standing.isDecided() || fallen;
    }

    @Override
    public Score score() {
        boolean reached = highest >= TOP.size().z();
        String finding = String.format(
                Locale.ROOT,
                "%s%s",
                reached ? "reached the top" : "did not reach the top",
                fallen ? ", and fell" : standing.isDecided() ? ", and stood there for 3 s" : "");
        if (standing.isDecided()) {
            return Score.passed(finding);
        }
        if (fallen) {
            return Score.failed(
                    reached ? 3 : 0, finding, "Walk slowly: 0.2 m/s is safe on the slope. Stop in front of the steps.");
        }
        return Score.failed(
                reached ? 4 : 0,
                finding,
                reached
                        ? "Stop at the top (x = -3.0 to x = -2.3) and stand still for 3 s."
                        : "The slope is 2 m wide and begins at x = -4.2. Walk to (-4.5, 0) first, turn to"
                                + " a heading of 0°, then walk up.");
    }
}
