package org.robonewbie.competition.contest;

import java.util.Map;
import java.util.function.Function;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.trial.Challenge;
import org.robonewbie.trial.Measure;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.TrialHook;
import org.robonewbie.trial.WorldState;

/**
 * Challenge for a single robot, scored by a measure. The ball is on the centre spot.
 *
 * @param start start pose of the robot
 * @param measure measure, which also determines when the trial ends
 * @param hook external events that disturb the robot
 * @param results extracts the measured values from the measure
 * @param <M> type of the measure
 */
record SoloChallenge<M extends Measure>(
        StartPlace start, M measure, TrialHook hook, Function<M, Map<String, Double>> results) implements Challenge {

    /** Creates a challenge without disturbances. */
    SoloChallenge(StartPlace start, M measure, Function<M, Map<String, Double>> results) {
        this(start, measure, trial -> {}, results);
    }

    @Override
    public Scene scene(RandomSource random) {
        Pose2d place = new Pose2d(start.x(), start.y(), start.degrees());
        return Scene.of(RobotStart.at(place).withTeam(RobotStart.TEAM, start.number()));
    }

    @Override
    public void act(Trial trial) {
        hook.act(trial);
    }

    @Override
    public void see(WorldState state) {
        measure.see(state);
    }

    @Override
    public double value() {
        return measure.value();
    }

    @Override
    public String unit() {
        return measure.unit();
    }

    @Override
    public boolean isLargerBetter() {
        return measure.isLargerBetter();
    }

    @Override
    public boolean isDecided() {
        return measure.isDecided();
    }

    @Override
    public Map<String, Double> figures() {
        return results.apply(measure);
    }
}
