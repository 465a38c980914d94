package org.robonewbie.learning.design;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import org.robonewbie.agent.walk.FootPose;
import org.robonewbie.agent.walk.Stance;
import org.robonewbie.agent.walk.TorsoPose;
import org.robonewbie.learning.rehearsal.KickTrial;
import org.robonewbie.learning.search.SearchPlan;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.motion.BallPlace;
import org.robonewbie.nao.motion.Keyframe;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.Posture;

/**
 * A kick with the right foot, from stance to stance: the weight goes to the left foot, the right leg swings back, forward through
 * the ball, and back to the ground; the torso bends and moves with it. The kick with the left foot is its mirror image.
 */
public final class KickDesign extends SearchedDesign {

    /** How many coordinates a kick has. */
    public static final int PARAMETERS = 32;

    private static final double HALF_WIDTH = 0.055;

    private final String name;
    private final String does;
    private final double wantedMetres;

    /**
     * Describes a kick.
     *
     * @param name name of the motion; "right" in it becomes "left" in its mirror image
     * @param does what the robot does
     * @param wantedMetres how far the ball is to roll
     * @param start first guess; missing coordinates are 0
     * @param plan the plan of the search
     */
    public KickDesign(String name, String does, double wantedMetres, double[] start, SearchPlan plan) {
        super(Arrays.copyOf(start, PARAMETERS), plan);
        this.name = name;
        this.does = does;
        this.wantedMetres = wantedMetres;
    }

    @Override
    public List<DescribedMotion> motions(double[] x) {
        BallPlace ball = ball(x);
        String start = String.format(
                Locale.ROOT,
                "stance, ball %.0f cm ahead of the torso and %.1f cm to the right, give or take 1 cm",
                100 * ball.ahead(),
                -100 * ball.left());
        var kick = new DescribedMotion(motion(x), does, start, "stance").with("ball", ball.toString());
        return List.of(kick.mirrored().with("ball", ball.mirrored().toString()), kick);
    }

    @Override
    public double cost(double[] x, long seed) {
        KickTrial trial = KickTrial.quick(motion(x), ball(x), seed);
        double shortfall = Math.abs(trial.metres() - wantedMetres) / wantedMetres;
        return (trial.standing() ? 0 : 2 + trial.fallCost())
                + 3 * Math.min(1, shortfall)
                + (shortfall > 0.25 ? 1 + 2 * Math.min(1, shortfall) : 0)
                + Math.min(1, Math.abs(trial.degreesAside()) / 30)
                + 0.1 * trial.seconds()
                + Costs.beyond(x, 5);
    }

    private static BallPlace ball(double[] x) {
        double ahead = Math.round(1000 * (0.19 + 0.01 * x[26])) / 1000.0;
        double left = Math.round(1000 * (-HALF_WIDTH + 0.01 * x[27])) / 1000.0;
        return new BallPlace(ahead, left);
    }

    private Motion motion(double[] x) {
        Torso lifting = new Torso(0, 0, 0, 0, 0);
        Torso back = new Torso(1.2 * x[10], x[4], x[20], 0, x[23]);
        Torso forth = new Torso(x[14], x[5], x[21], x[22], x[24]);
        Swing lifted = new Swing(50, -98, 48, 0, 0);
        Swing wound = new Swing(20 + 10 * x[11], -95 + 10 * x[12], 70 + 10 * x[13], x[28], 30);
        Swing struck = new Swing(65 + 10 * x[15], -40 + 10 * x[16], -20 + 10 * x[17], x[29], -30);
        Swing drawn = new Swing(50 + 5 * x[18], -98, 48, 0, -10);
        return new Motion(
                name,
                List.of(
                        new Keyframe(Math.max(260, millis(400, x[0])), shifted(x)),
                        new Keyframe(millis(240, x[25]), swung(x, lifting, lifted)),
                        new Keyframe(millis(240, x[1]), swung(x, back, wound)),
                        new Keyframe(millis(140, 0.5 * x[2]), swung(x, forth, struck)),
                        new Keyframe(Math.max(160, millis(240, x[3])), swung(x, lifting, drawn)),
                        new Keyframe(millis(300, x[30]), shifted(x)),
                        new Keyframe(Math.max(300, millis(500, x[31])), Stance.POSTURE)));
    }

    private static int millis(int guess, double change) {
        return (int) Math.max(60, Math.round((guess + 60 * change) / 20) * 20);
    }

    /** Both feet on the ground, the weight on the left one. */
    private static Posture shifted(double[] x) {
        return Costs.rounded(standing(x, new Torso(0, 0, 0, 0, 0), Stance.POSTURE));
    }

    /** The right leg in the air. */
    private static Posture swung(double[] x, Torso torso, Swing swing) {
        Posture arms = Stance.POSTURE
                .with(Joint.LEFT_SHOULDER_PITCH, Stance.POSTURE.degrees(Joint.LEFT_SHOULDER_PITCH) + 10 - swing.arms())
                .with(
                        Joint.RIGHT_SHOULDER_PITCH,
                        Stance.POSTURE.degrees(Joint.RIGHT_SHOULDER_PITCH) + 10 + swing.arms())
                .with(Joint.LEFT_SHOULDER_YAW, 25)
                .with(Joint.RIGHT_SHOULDER_YAW, -25);
        return Costs.rounded(standing(x, torso, arms)
                .with(Joint.RIGHT_HIP_YAW_PITCH, 0)
                .with(Joint.RIGHT_HIP_ROLL, -8 + 3 * x[9] + 3 * swing.aside())
                .with(Joint.RIGHT_HIP_PITCH, swing.hip())
                .with(Joint.RIGHT_KNEE_PITCH, swing.knee())
                .with(Joint.RIGHT_FOOT_PITCH, swing.foot())
                .with(Joint.RIGHT_FOOT_ROLL, 0));
    }

    private static Posture standing(double[] x, Torso torso, Posture arms) {
        double sway = 0.05 + 0.01 * x[6] + 0.004 * torso.aside();
        double ahead = -0.005 + 0.01 * x[7] - 0.01 * torso.ahead();
        double height = Math.min(0.375, 0.34 + 0.005 * x[19] + 0.005 * torso.height());
        TorsoPose pose = new TorsoPose(height, 3 + 4 * torso.lean(), 3 * x[8]);
        double turn = -4 * torso.turn();
        return Costs.rounded(pose.above(
                Costs.kinematics(),
                arms,
                new FootPose(ahead, HALF_WIDTH - sway, 0, turn, 0),
                new FootPose(ahead, -HALF_WIDTH - sway, 0, turn, 0)));
    }

    /** How the torso moves at one moment of a kick, in units of the search. */
    private record Torso(double lean, double aside, double ahead, double height, double turn) {}

    /** How the right leg is held at one moment of a kick, in degrees, and the arms with it. */
    private record Swing(double hip, double knee, double foot, double aside, double arms) {}
}
