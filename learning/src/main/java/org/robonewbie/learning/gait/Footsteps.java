package org.robonewbie.learning.gait;

import java.util.ArrayList;
import java.util.List;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.Leg;
import org.robonewbie.nao.motion.Keyframe;
import org.robonewbie.nao.motion.Posture;

/**
 * Turns footsteps into keyframes. While one foot swings to its new place, the torso moves on evenly to the middle between both
 * feet and sways to the side of the standing leg; inverse kinematics gives the angles.
 *
 * <pre>{@code
 * List<Keyframe> keyframes = new Footsteps(gait, FootPlace.LEFT, FootPlace.RIGHT)
 *         .step(Leg.LEFT, FootPlace.LEFT.moved(0.05, 0))
 *         .step(Leg.RIGHT, FootPlace.RIGHT.moved(0.05, 0))
 *         .keyframes();
 * }</pre>
 */
public final class Footsteps {

    private static final double ANKLE_BEHIND_TORSO = 0.005;
    private static final double MOST_ARM_DEGREES = 45;

    private final Gait gait;
    private final List<Keyframe> keyframes = new ArrayList<>();
    private FootPlace left;
    private FootPlace right;
    private double vigour = 1;

    /**
     * Begins with both feet on the ground.
     *
     * @param gait how the robot steps
     * @param left where the left foot stands
     * @param right where the right foot stands
     */
    public Footsteps(Gait gait, FootPlace left, FootPlace right) {
        this.gait = gait;
        this.left = left;
        this.right = right;
    }

    /**
     * Swings one foot to a new place.
     *
     * @param leg which foot
     * @param target where it is set down
     * @return this
     */
    public Footsteps step(Leg leg, FootPlace target) {
        return step(leg, target, 1);
    }

    /**
     * Swings one foot to a new place while the swaying becomes stronger or weaker, to begin or to end a walk.
     *
     * @param leg which foot
     * @param target where it is set down
     * @param vigourAtEnd 1 sways and lifts as the gait says, 0 not at all
     * @return this
     */
    public Footsteps step(Leg leg, FootPlace target, double vigourAtEnd) {
        FootPlace start = place(leg);
        FootPlace middle = middle();
        double vigourAtStart = vigour;
        vigour = vigourAtEnd;
        putDown(leg, target);
        FootPlace nextMiddle = middle();
        for (int i = 1; i <= gait.keyframesPerStep(); i++) {
            double time = (double) i / gait.keyframesPerStep();
            double strength = vigourAtStart + time * (vigourAtEnd - vigourAtStart);
            StepMoment moment = new StepMoment(gait, leg, time, strength);
            putDown(leg, start.towards(target, moment.travelled()));
            add(moment, middle.towards(nextMiddle, time));
        }
        putDown(leg, target);
        return this;
    }

    /**
     * Adds a posture that no step leads to, such as the stance at the end.
     *
     * @param durationMillis time to get there
     * @param posture the posture
     * @return this
     */
    public Footsteps end(int durationMillis, Posture posture) {
        keyframes.add(new Keyframe(durationMillis, posture));
        return this;
    }

    /**
     * Gives the result.
     *
     * @return all keyframes so far
     */
    public List<Keyframe> keyframes() {
        return List.copyOf(keyframes);
    }

    private FootPlace place(Leg leg) {
        return leg == Leg.LEFT ? left : right;
    }

    private void putDown(Leg leg, FootPlace place) {
        if (leg == Leg.LEFT) {
            left = place;
        } else {
            right = place;
        }
    }

    private FootPlace middle() {
        return left.towards(right, 0.5);
    }

    private void add(StepMoment moment, FootPlace middle) {
        Posture arms =
                armsSwinging(left.seenFrom(middle).x() - right.seenFrom(middle).x());
        TorsoPose torso = new TorsoPose(gait.torsoHeight() + moment.bounce(), gait.leanDegrees(), moment.rollDegrees());
        Posture posture = torso.above(arms, foot(moment, Leg.LEFT, middle), foot(moment, Leg.RIGHT, middle));
        keyframes.add(
                new Keyframe(gait.stepMillis() / gait.keyframesPerStep(), rounded(moment.withLiftedHip(posture))));
    }

    private FootPose foot(StepMoment moment, Leg leg, FootPlace middle) {
        Vector3 place = place(leg).seenFrom(middle);
        double outward = leg == Leg.LEFT ? gait.feetApart() : -gait.feetApart();
        boolean swings = leg == moment.leg();
        return new FootPose(
                place.x() + gait.feetForward() - ANKLE_BEHIND_TORSO,
                place.y() + outward - moment.sway(),
                swings ? moment.lift() : 0,
                place(leg).yawDegrees() - middle.yawDegrees(),
                swings ? moment.toeDegrees() : 0);
    }

    private Posture armsSwinging(double leftAhead) {
        double swing = Math.max(-MOST_ARM_DEGREES, Math.min(MOST_ARM_DEGREES, gait.armSwing() * leftAhead));
        Posture stance = Stance.POSTURE;
        return stance.with(Joint.LEFT_SHOULDER_PITCH, stance.degrees(Joint.LEFT_SHOULDER_PITCH) - swing)
                .with(Joint.RIGHT_SHOULDER_PITCH, stance.degrees(Joint.RIGHT_SHOULDER_PITCH) + swing);
    }

    private static Posture rounded(Posture posture) {
        double[] degrees = posture.clamped().toArray();
        for (int i = 0; i < degrees.length; i++) {
            degrees[i] = Math.round(degrees[i] * 100) / 100.0;
        }
        return Posture.of(degrees);
    }
}
