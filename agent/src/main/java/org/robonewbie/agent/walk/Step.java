package org.robonewbie.agent.walk;

import org.robonewbie.nao.Joint;
import org.robonewbie.nao.kinematics.InverseKinematics;
import org.robonewbie.nao.kinematics.Leg;
import org.robonewbie.nao.kinematics.MutablePose;
import org.robonewbie.nao.motion.MutablePosture;
import org.robonewbie.nao.motion.Posture;

/**
 * One step: a foot swings to its new place while the other one stands, and the torso moves on evenly to the middle between both
 * feet and sways to the side of the standing leg; inverse kinematics gives the angles. The object can be used again for the next
 * step, so that walking makes no garbage.
 *
 * <pre>{@code
 * Step step = new Step(gait, Leg.LEFT, FootPlace.LEFT, FootPlace.LEFT.moved(0.05, 0), FootPlace.RIGHT, carriage, carriage);
 * Posture halfWay = step.posture(kinematics, 0.5);
 * }</pre>
 */
public final class Step {

    private static final double ANKLE_BEHIND_TORSO = 0.005;
    private static final double MOST_ARM_DEGREES = 45;

    private final Gait gait;
    private final MovingPlace start = new MovingPlace();
    private final MovingPlace target = new MovingPlace();
    private final MovingPlace support = new MovingPlace();
    private final Carriage before = new Carriage();
    private final Carriage after = new Carriage();
    private Leg leg = Leg.LEFT;

    private final StepMoment moment;
    private final Carriage carriage = new Carriage();
    private final MovingPlace swinging = new MovingPlace();
    private final MovingPlace middle = new MovingPlace();
    private final MutablePose foot = new MutablePose();

    /** Prepares steps of a gait. */
    Step(Gait gait) {
        this.gait = gait;
        moment = new StepMoment(gait);
    }

    /**
     * Describes a step.
     *
     * @param gait how the robot steps
     * @param leg which leg swings
     * @param start where its foot stood
     * @param target where its foot is set down
     * @param support where the other foot stands
     * @param before how the torso is carried at the beginning
     * @param after how the torso is carried at the end
     */
    public Step(
            Gait gait, Leg leg, FootPlace start, FootPlace target, FootPlace support, Carriage before, Carriage after) {
        this(gait);
        begin(leg, new MovingPlace(start), new MovingPlace(support), before);
        this.target.set(target);
        this.after.set(after);
    }

    /** Begins the next step where the feet are; {@link #target} and {@link #after} say where it leads. */
    void begin(Leg swings, MovingPlace from, MovingPlace stands, Carriage now) {
        leg = swings;
        start.set(from);
        support.set(stands);
        before.set(now);
    }

    /** Where the foot is set down. */
    MovingPlace target() {
        return target;
    }

    /** How the torso is carried at the end. */
    Carriage after() {
        return after;
    }

    /**
     * Calculates a posture of this step, without any correction.
     *
     * @param kinematics the robot's
     * @param time which part of the step is over, 0 to 1
     * @return the posture
     */
    public Posture posture(InverseKinematics kinematics, double time) {
        MutablePosture posture = new MutablePosture(Stance.POSTURE);
        setTime(time);
        place(posture, kinematics, new Correction());
        return posture.toPosture();
    }

    /** Goes to a moment of the step, 0 to 1. */
    void setTime(double time) {
        carriage.setBetween(before, after, time);
        moment.set(leg, time, carriage.vigour());
        middle.set(start);
        middle.approach(target, time);
        middle.approach(support, 0.5);
    }

    /** How much the torso bows forward now, as planned. */
    double leanDegrees() {
        return carriage.leanDegrees();
    }

    /** How much the torso leans to the right now, as planned. */
    double rollDegrees() {
        return moment.rollDegrees();
    }

    /** How much the gait's movements count now, 0 to 1. */
    double vigour() {
        return carriage.vigour();
    }

    /** Puts the limbs where they are now; the search for the legs' angles begins with the posture. */
    void place(MutablePosture posture, InverseKinematics kinematics, Correction correction) {
        double travelled = moment.travelled();
        swinging.set(start);
        swinging.approach(target, travelled);
        swinging.go(correction.swingForward() * travelled, correction.swingLeft() * travelled, 0);
        place(swinging, leg, moment.lift(), moment.toeDegrees());
        kinematics.place(leg, foot, posture);
        place(support, leg.other(), 0, 0);
        kinematics.place(leg.other(), foot, posture);
        swingArms(posture, swinging.aheadOf(middle) - support.aheadOf(middle));
        moment.liftHip(posture);
        correct(posture, correction);
    }

    /** Where the swinging foot is now: at the end of the step the place where it was set down. */
    MovingPlace swinging() {
        return swinging;
    }

    private void place(MovingPlace sole, Leg which, double up, double toesUpDegrees) {
        double outward = which == Leg.LEFT ? gait.feetApart() : -gait.feetApart();
        TorsoPose.goToGround(foot, gait.torsoHeight() + moment.bounce(), carriage.leanDegrees(), moment.rollDegrees());
        FootPose.goToFoot(
                foot,
                sole.aheadOf(middle) + carriage.feetForward() - ANKLE_BEHIND_TORSO,
                sole.leftOf(middle) + outward - moment.sway(),
                up,
                sole.yawDegrees() - middle.yawDegrees(),
                toesUpDegrees);
    }

    private void swingArms(MutablePosture posture, double metres) {
        double leftAhead = leg == Leg.LEFT ? metres : -metres;
        double swing = Math.max(-MOST_ARM_DEGREES, Math.min(MOST_ARM_DEGREES, gait.armSwing() * leftAhead));
        Posture stance = Stance.POSTURE;
        posture.set(Joint.LEFT_SHOULDER_PITCH, stance.degrees(Joint.LEFT_SHOULDER_PITCH) - swing);
        posture.set(Joint.RIGHT_SHOULDER_PITCH, stance.degrees(Joint.RIGHT_SHOULDER_PITCH) + swing);
    }

    private static void correct(MutablePosture posture, Correction correction) {
        posture.add(Joint.LEFT_FOOT_PITCH, correction.anklePitchDegrees());
        posture.add(Joint.RIGHT_FOOT_PITCH, correction.anklePitchDegrees());
        posture.add(Joint.LEFT_HIP_PITCH, correction.hipPitchDegrees());
        posture.add(Joint.RIGHT_HIP_PITCH, correction.hipPitchDegrees());
        posture.add(Joint.LEFT_FOOT_ROLL, correction.ankleRollDegrees());
        posture.add(Joint.RIGHT_FOOT_ROLL, correction.ankleRollDegrees());
        posture.add(Joint.LEFT_HIP_ROLL, correction.hipRollDegrees());
        posture.add(Joint.RIGHT_HIP_ROLL, correction.hipRollDegrees());
        posture.clamp();
    }
}
