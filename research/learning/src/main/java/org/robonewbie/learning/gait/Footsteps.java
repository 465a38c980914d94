package org.robonewbie.learning.gait;

import java.util.ArrayList;
import java.util.List;
import org.robonewbie.agent.walk.Gait;
import org.robonewbie.agent.walk.Stance;
import org.robonewbie.agent.walk.Step;
import org.robonewbie.agent.walk.TorsoPosture;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.kinematics.InverseKinematics;
import org.robonewbie.nao.kinematics.Leg;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.Keyframe;
import org.robonewbie.nao.motion.Posture;

/**
 * Turns footsteps into keyframes. While one foot swings to its new place, the torso moves on evenly to the middle between both
 * feet and sways to the side of the standing leg; inverse kinematics gives the angles.
 *
 * <pre>{@code
 * List<Keyframe> keyframes = new Footsteps(gait, Stance.LEFT_FOOT, Stance.RIGHT_FOOT)
 *         .step(Leg.LEFT, Stance.LEFT_FOOT.then(0.05, 0, 0))
 *         .step(Leg.RIGHT, Stance.RIGHT_FOOT.then(0.05, 0, 0))
 *         .keyframes();
 * }</pre>
 */
public final class Footsteps {

    private final InverseKinematics kinematics = new InverseKinematics(RobotType.TYPE_0);
    private final Gait gait;
    private final List<Keyframe> keyframes = new ArrayList<>();
    private Pose2d left;
    private Pose2d right;
    private double amplitude = 1;
    private int takingUpMillis;

    /**
     * Begins with both feet on the ground.
     *
     * @param gait how the robot steps
     * @param left where the left foot stands
     * @param right where the right foot stands
     */
    public Footsteps(Gait gait, Pose2d left, Pose2d right) {
        this.gait = gait;
        this.left = left;
        this.right = right;
    }

    /**
     * Begins in the stance: before the first foot swings, the body takes up the gait without a jerk.
     *
     * @param gait how the robot steps
     * @param durationMillis time for that
     * @return steps of a robot with its feet side by side
     */
    public static Footsteps fromStance(Gait gait, int durationMillis) {
        Footsteps steps = new Footsteps(gait, Stance.LEFT_FOOT, Stance.RIGHT_FOOT);
        steps.takingUpMillis = durationMillis;
        return steps;
    }

    /**
     * Swings one foot to a new place.
     *
     * @param leg which foot
     * @param target where it is set down
     * @return this
     */
    public Footsteps step(Leg leg, Pose2d target) {
        return step(leg, target, 1);
    }

    /**
     * Swings one foot to a new place while the swaying becomes stronger or weaker, to begin or to end a walk.
     *
     * @param leg which foot
     * @param target where it is set down
     * @param amplitudeAtEnd 1 sways and lifts as the gait says, 0 not at all
     * @return this
     */
    public Footsteps step(Leg leg, Pose2d target, double amplitudeAtEnd) {
        TorsoPosture before = TorsoPosture.of(gait, amplitude);
        TorsoPosture after = TorsoPosture.of(gait, amplitudeAtEnd);
        Step step = new Step(gait, leg, place(leg), target, place(leg.other()), before, after);
        if (takingUpMillis > 0 && keyframes.isEmpty()) {
            keyframes.add(new Keyframe(takingUpMillis, posture(step, 0)));
        }
        for (int i = 1; i <= gait.keyframesPerStep(); i++) {
            double time = (double) i / gait.keyframesPerStep();
            keyframes.add(new Keyframe(gait.stepMillis() / gait.keyframesPerStep(), posture(step, time)));
        }
        amplitude = amplitudeAtEnd;
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

    /** {@return all keyframes so far} */
    public List<Keyframe> keyframes() {
        return List.copyOf(keyframes);
    }

    private Posture posture(Step step, double time) {
        return rounded(step.posture(kinematics, time));
    }

    private Pose2d place(Leg leg) {
        return leg == Leg.LEFT ? left : right;
    }

    private void putDown(Leg leg, Pose2d place) {
        if (leg == Leg.LEFT) {
            left = place;
        } else {
            right = place;
        }
    }

    private static Posture rounded(Posture posture) {
        double[] degrees = posture.clamped().toArray();
        for (int i = 0; i < degrees.length; i++) {
            degrees[i] = Math.round(degrees[i] * 100) / 100.0;
        }
        return Posture.of(degrees);
    }
}
