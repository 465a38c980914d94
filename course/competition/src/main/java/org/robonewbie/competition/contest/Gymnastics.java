package org.robonewbie.competition.contest;

import java.util.List;
import java.util.Map;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.kinematics.BodyPoses;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.trial.Measure;
import org.robonewbie.trial.WorldState;
import org.robonewbie.trial.measure.SustainedCondition;
import org.robonewbie.trial.measure.Turn;

/**
 * Counts the gymnastic elements that the robot has performed, in any order: both arms up, a squat, a stand on one leg, a
 * bow, a full turn, and lying down and getting up again.
 */
final class Gymnastics implements Measure {

    private static final double ARMS_UP_DEGREES = 70;
    private static final double SQUAT_METRES = 0.31;
    private static final double FOOT_METRES = 0.05;
    private static final double BOW_DEGREES = 30;
    private static final double LYING_DEGREES = 75;
    private static final double FULL_TURN_DEGREES = 360;

    private final List<SustainedCondition> poses = List.of(
            new SustainedCondition(1, state -> state.robot().isStanding() && areArmsUp(state.robot())),
            new SustainedCondition(
                    1,
                    state -> state.robot().isStanding()
                            && state.robot().position().z() < SQUAT_METRES),
            new SustainedCondition(
                    2,
                    state ->
                            state.robot().isStanding() && isFootUp(state.robot().limbs())),
            new SustainedCondition(1, state -> isBowing(state.robot().tiltDegrees())));
    private final SustainedCondition lying =
            new SustainedCondition(1, state -> state.robot().tiltDegrees() > LYING_DEGREES);
    private final SustainedCondition up =
            new SustainedCondition(1, state -> state.robot().isStanding());
    private Turn turn = new Turn();
    private double turnedBefore;
    private boolean turned;
    private int elements;
    private double lastSeconds;

    @Override
    public void see(WorldState state) {
        poses.forEach(pose -> pose.see(state));
        watchTurn(state);
        lying.see(state);
        if (lying.isDecided()) {
            up.see(state);
        }
        int shown = (int) poses.stream().filter(SustainedCondition::isDecided).count()
                + (turned ? 1 : 0)
                + (up.isDecided() ? 1 : 0);
        lastSeconds = shown > elements ? state.seconds() : lastSeconds;
        elements = shown;
    }

    /** Accumulates the robot's rotation while it is standing; rotation during a fall or on the ground does not count. */
    private void watchTurn(WorldState state) {
        if (state.robot().isStanding()) {
            turn.see(state);
        } else {
            turnedBefore += turn.value();
            turn = new Turn();
        }
        turned |= Math.abs(turnedBefore + turn.value()) >= FULL_TURN_DEGREES;
    }

    private static boolean areArmsUp(BodyState body) {
        return body.degrees(Joint.LEFT_SHOULDER_PITCH) > ARMS_UP_DEGREES
                && body.degrees(Joint.RIGHT_SHOULDER_PITCH) > ARMS_UP_DEGREES;
    }

    private static boolean isFootUp(BodyPoses limbs) {
        return Math.abs(limbs.link("lfoot").position().z()
                        - limbs.link("rfoot").position().z())
                > FOOT_METRES;
    }

    private static boolean isBowing(double tiltDegrees) {
        return tiltDegrees >= BOW_DEGREES && tiltDegrees < LYING_DEGREES;
    }

    @Override
    public double value() {
        return elements;
    }

    /** Returns the number of elements and, if there are any, the time of the last one. */
    Map<String, Double> figures() {
        return elements == 0
                ? Map.of("elements", 0.0)
                : Map.of("elements", (double) elements, "lastSeconds", lastSeconds);
    }

    @Override
    public boolean isDecided() {
        return elements == poses.size() + 2;
    }
}
