package org.robonewbie.learning.design;

import java.util.List;
import java.util.function.UnaryOperator;
import org.robonewbie.agent.walk.Gait;
import org.robonewbie.agent.walk.Stance;
import org.robonewbie.learning.gait.Footsteps;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.kinematics.Leg;
import org.robonewbie.nao.motion.Motion;

/**
 * Steps on the spot or to the left, from stance to stance, with the gait of the walk; the right-hand motion is its mirror
 * image. Nothing is searched for: the distance between the feet follows from trials.
 */
public final class FootworkDesign extends DrawnDesign {

    private static final double FIRST_VIGOUR = 0.7;
    private static final int END_MILLIS = 300;

    private final String name;
    private final String does;
    private final Gait gait;
    private final UnaryOperator<Pose2d> way;
    private final int rounds;

    /**
     * Describes footwork to the left.
     *
     * @param name name of the motion; "left" in it becomes "right" in its mirror image
     * @param does what the robot does
     * @param gait how it steps
     * @param way where a foot is set in each round, seen from where it stands at first
     * @param rounds how often each foot is set
     */
    public FootworkDesign(String name, String does, Gait gait, UnaryOperator<Pose2d> way, int rounds) {
        this.name = name;
        this.does = does;
        this.gait = gait;
        this.way = way;
        this.rounds = rounds;
    }

    @Override
    List<DescribedMotion> motions() {
        Footsteps steps = new Footsteps(gait, Stance.LEFT_FOOT, Stance.RIGHT_FOOT);
        Pose2d left = Stance.LEFT_FOOT;
        Pose2d right = Stance.RIGHT_FOOT;
        for (int i = 0; i < rounds; i++) {
            left = way.apply(left);
            right = way.apply(right);
            steps.step(Leg.LEFT, left, i == 0 ? FIRST_VIGOUR : 1).step(Leg.RIGHT, right);
        }
        steps.end(END_MILLIS, Stance.POSTURE);
        var motion = new DescribedMotion(new Motion(name, steps.keyframes()), does, "stance", "stance");
        return List.of(motion, motion.mirrored());
    }
}
