package org.robonewbie.learning.design;

import java.util.List;
import org.robonewbie.agent.walk.FootPose;
import org.robonewbie.agent.walk.Stance;
import org.robonewbie.agent.walk.TorsoPose;
import org.robonewbie.learning.search.SearchPlan;
import org.robonewbie.learning.trial.KickTrial;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.motion.Keyframe;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.Posture;

/**
 * A kick with the right foot, from stance to stance: the weight goes to the left foot, the right leg swings back, forward through
 * the ball, and back to the ground. The kick with the left foot is its mirror image.
 */
public final class KickDesign implements MotionDesign {

    private static final double HALF_WIDTH = 0.055;

    private final String name;
    private final String does;
    private final double wantedMetres;
    private final double[] start;
    private final SearchPlan plan;

    /**
     * Describes a kick.
     *
     * @param name name of the motion; "right" in it becomes "left" in its mirror image
     * @param does what the robot does
     * @param wantedMetres how far the ball shall roll
     * @param start first guess
     * @param plan how it is searched for
     */
    public KickDesign(String name, String does, double wantedMetres, double[] start, SearchPlan plan) {
        this.name = name;
        this.does = does;
        this.wantedMetres = wantedMetres;
        this.start = start.clone();
        this.plan = plan;
    }

    @Override
    public double[] start() {
        return start.clone();
    }

    @Override
    public SearchPlan plan() {
        return plan;
    }

    @Override
    public List<DescribedMotion> motions(double[] x) {
        var kick = new DescribedMotion(
                motion(x), does, "stance, ball 17 to 21 cm ahead of the torso and 5.5 cm to the right", "stance");
        return List.of(kick.mirrored(), kick);
    }

    @Override
    public double cost(double[] x, long seed) {
        KickTrial trial = KickTrial.run(motion(x), seed, -HALF_WIDTH);
        double shortfall = Math.abs(trial.metres() - wantedMetres) / wantedMetres;
        return (trial.standing() ? 0 : 2 + trial.fallCost())
                + 3 * Math.min(1, shortfall)
                + Math.min(1, Math.abs(trial.degreesAside()) / 30)
                + 0.1 * trial.seconds()
                + Costs.beyond(x, 4);
    }

    private Motion motion(double[] x) {
        return new Motion(
                name,
                List.of(
                        new Keyframe(Math.max(260, millis(400, x[0])), shifted(x)),
                        new Keyframe(240, swung(x, 0, 0, 50, -98, 48, 0)),
                        new Keyframe(
                                Math.max(180, millis(240, x[1])),
                                swung(x, 1.2 * x[10], x[4], 20 + 10 * x[11], -95 + 10 * x[12], 70 + 10 * x[13], 30)),
                        new Keyframe(
                                millis(140, 0.5 * x[2]),
                                swung(x, x[14], x[5], 65 + 10 * x[15], -40 + 10 * x[16], -20 + 10 * x[17], -30)),
                        new Keyframe(Math.max(160, millis(240, x[3])), swung(x, 0, 0, 50 + 5 * x[18], -98, 48, -10)),
                        new Keyframe(300, shifted(x)),
                        new Keyframe(500, Stance.POSTURE)));
    }

    private static int millis(int guess, double change) {
        return (int) Math.max(60, Math.round((guess + 60 * change) / 20) * 20);
    }

    /** Both feet on the ground, the weight on the left one. */
    private static Posture shifted(double[] x) {
        return Costs.rounded(standing(x, 0, 0, Stance.POSTURE));
    }

    /** The right leg in the air. */
    private static Posture swung(
            double[] x, double lean, double aside, double hip, double knee, double foot, double arms) {
        Posture arm = Stance.POSTURE
                .with(Joint.LEFT_SHOULDER_PITCH, Stance.POSTURE.degrees(Joint.LEFT_SHOULDER_PITCH) + 10 - arms)
                .with(Joint.RIGHT_SHOULDER_PITCH, Stance.POSTURE.degrees(Joint.RIGHT_SHOULDER_PITCH) + 10 + arms)
                .with(Joint.LEFT_SHOULDER_YAW, 25)
                .with(Joint.RIGHT_SHOULDER_YAW, -25);
        return Costs.rounded(standing(x, lean, aside, arm)
                .with(Joint.RIGHT_HIP_YAW_PITCH, 0)
                .with(Joint.RIGHT_HIP_ROLL, -8 + 3 * x[9])
                .with(Joint.RIGHT_HIP_PITCH, hip)
                .with(Joint.RIGHT_KNEE_PITCH, knee)
                .with(Joint.RIGHT_FOOT_PITCH, foot)
                .with(Joint.RIGHT_FOOT_ROLL, 0));
    }

    private static Posture standing(double[] x, double lean, double aside, Posture arms) {
        double sway = 0.05 + 0.01 * x[6] + 0.004 * aside;
        double ahead = -0.005 + 0.01 * x[7];
        TorsoPose torso = new TorsoPose(0.34, 3 + 4 * lean, 3 * x[8]);
        Posture posture = torso.above(
                Costs.kinematics(),
                arms,
                FootPose.flat(ahead, HALF_WIDTH - sway),
                FootPose.flat(ahead, -HALF_WIDTH - sway));
        return Costs.rounded(posture);
    }
}
