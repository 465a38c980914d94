package org.robonewbie.learning.environment;

import java.util.Arrays;
import java.util.List;
import java.util.function.UnaryOperator;
import org.robonewbie.agent.walk.Stance;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.nao.motion.Keyframe;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.Posture;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.WorldState;

/**
 * Task: get up from lying on its front, and remain standing. The episode is never terminated, so getting up early yields the largest
 * return.
 */
class GetUpTraining extends TrainingTask {

    private static final double HIGH_METRES = 0.33;
    private static final double UPRIGHT_DEGREES = 20;
    private static final double MAX_NEWTONS = 20;
    private static final Posture LEANING = Stance.POSTURE
            .with(Joint.LEFT_FOOT_PITCH, 70)
            .with(Joint.RIGHT_FOOT_PITCH, 70)
            .with(Joint.LEFT_HIP_PITCH, 20)
            .with(Joint.RIGHT_HIP_PITCH, 20);
    private static final Scene LYING = lying(posture -> posture);
    private static final List<Joint> BODY = Arrays.stream(Joint.values())
            .filter(joint -> !joint.name().startsWith("NECK"))
            .toList();

    private double totalReward;
    private boolean up;

    /** Creates a scene in which the robot leans forward until it falls; a function may modify its postures. */
    static Scene lying(UnaryOperator<Posture> change) {
        Posture leaning = change.apply(LEANING);
        Posture resting = change.apply(Stance.POSTURE);
        Motion fall = new Motion(
                "fall",
                List.of(
                        new Keyframe(300, leaning),
                        new Keyframe(1500, leaning),
                        new Keyframe(600, resting),
                        new Keyframe(1000, resting)));
        return Scene.of(RobotStart.at(1.5, 0).after(TO_THE_STANCE, fall)).withBall(2.5, 2);
    }

    @Override
    public Scene scene(RandomSource random) {
        return LYING;
    }

    @Override
    public void begin(Trial trial) {
        trial.robot(0)
                .push(new Vector3(
                        random().between(-MAX_NEWTONS, MAX_NEWTONS), random().between(-MAX_NEWTONS, MAX_NEWTONS), 0));
    }

    @Override
    public List<Joint> joints() {
        return BODY;
    }

    @Override
    public double rangeDegrees() {
        return 90;
    }

    @Override
    protected void see(WorldState first, WorldState now) {
        BodyState body = watched(now);
        double upright = Math.max(0, 1 - body.tiltDegrees() / 90);
        double high = Math.max(0, Math.min(1, body.position().z() / HIGH_METRES));
        totalReward += Cycle.SECONDS * upright * high;
        up = body.tiltDegrees() < UPRIGHT_DEGREES && body.position().z() > 0.9 * HIGH_METRES;
    }

    /** {@return whether the robot is standing} */
    @Override
    public boolean isDone() {
        return up;
    }

    @Override
    public boolean isDecided() {
        return false;
    }

    @Override
    public String rewardRule() {
        return "per second, the uprightness of the torso (1 upright, 0 at 90 degrees) times its height (1 from "
                + "0.33 m). The robot starts lying on its front";
    }

    @Override
    public String successRule() {
        return "stands";
    }

    @Override
    public double value() {
        return totalReward;
    }
}
