package org.robonewbie.competition.contest;

import java.util.List;
import java.util.Map;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.kinematics.BodyPoses;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.trial.Measure;
import org.robonewbie.trial.Moment;
import org.robonewbie.trial.measure.Held;
import org.robonewbie.trial.measure.Turn;

/**
 * How many of six elements the robot has shown, in any order: both arms up, a squat, a stand on one leg, a bow, a full turn,
 * and lying down and getting up again.
 */
final class Gymnastics implements Measure {

    private static final double ARMS_UP_DEGREES = 70;
    private static final double SQUAT_METRES = 0.31;
    private static final double FOOT_METRES = 0.05;
    private static final double BOW_DEGREES = 30;
    private static final double LYING_DEGREES = 75;
    private static final double FULL_TURN_DEGREES = 360;

    private final List<Held> poses = List.of(
            new Held(1, moment -> moment.robot().isStanding() && areArmsUp(moment.robot())),
            new Held(
                    1,
                    moment -> moment.robot().isStanding()
                            && moment.robot().position().z() < SQUAT_METRES),
            new Held(
                    2,
                    moment -> moment.robot().isStanding()
                            && isFootUp(moment.robot().limbs())),
            new Held(1, moment -> isBowing(moment.robot().tiltDegrees())));
    private final Held lying = new Held(1, moment -> moment.robot().tiltDegrees() > LYING_DEGREES);
    private final Held up = new Held(1, moment -> moment.robot().isStanding());
    private Turn turn = new Turn();
    private double turnedBefore;
    private boolean turned;
    private int elements;
    private double lastSeconds;

    @Override
    public void see(Moment moment) {
        poses.forEach(pose -> pose.see(moment));
        watchTurn(moment);
        lying.see(moment);
        if (lying.isDecided()) {
            up.see(moment);
        }
        int shown = (int) poses.stream().filter(Held::isDecided).count() + (turned ? 1 : 0) + (up.isDecided() ? 1 : 0);
        lastSeconds = shown > elements ? moment.seconds() : lastSeconds;
        elements = shown;
    }

    /** Turns on the feet add up; in a fall and on the ground nothing counts. */
    private void watchTurn(Moment moment) {
        if (moment.robot().isStanding()) {
            turn.see(moment);
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

    /** The number of elements, and when the last one was shown if there was one. */
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
