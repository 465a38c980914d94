package org.robonewbie.learning.rehearsal;

import java.util.Random;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.file.ShippedMotions;

/**
 * A robot that has fallen once and tries to get up as often as one likes: it lies as after its fall each time. That is much faster than
 * to let it fall again. It can be made harder: other friction, other mass, a hand that pushes.
 *
 * <pre>{@code
 * FallenRobot robot = FallenRobot.anyhow(Lying.ON_BACK, RobotType.TYPE_0, seed);
 * boolean up = robot.getUp(motion, 7, 1).success();
 * }</pre>
 */
public final class FallenRobot {

    private static final double GRIP_RANGE = 0.3;
    private static final double MASS_RANGE = 0.1;
    private static final double PUSH_NEWTONS = 3;

    private final Rehearsal fallen;

    private FallenRobot(Rehearsal fallen) {
        this.fallen = fallen;
        fallen.keep();
    }

    /**
     * Makes a robot fall that holds its arms anywhere.
     *
     * @param lying on which side it lies then
     * @param type how it is built
     * @param seed chooses the fall
     * @return the robot
     */
    public static FallenRobot anyhow(Lying lying, RobotType type, long seed) {
        return new FallenRobot(lying.fallen(type, seed));
    }

    /**
     * Makes a robot fall on purpose, out of the stance and by a motion.
     *
     * @param type how it is built
     * @param fall name of the motion, such as {@code fall-back}
     * @param seed chooses how long it lies, and small differences
     * @return the robot
     */
    public static FallenRobot after(RobotType type, String fall, long seed) {
        Rehearsal robot = Rehearsal.inStance(type, seed, 0);
        robot.allowFalls();
        robot.play(ShippedMotions.motion(fall));
        robot.hold(1 + 0.1 * new Random(seed).nextInt(7));
        return new FallenRobot(robot);
    }

    /**
     * Gets up from where it fell.
     *
     * @param motion how
     * @param seed chooses how friction, mass and pushes differ from the usual
     * @param hardness 0 for the usual world, 1 for up to 30 % more or less friction, 10 % of mass and a hand that pushes with 3 N
     * @param settlingSeconds how long it has to stand afterwards, seconds
     * @return what happened
     */
    public synchronized GetUpTrial getUp(Motion motion, long seed, double hardness, double settlingSeconds) {
        Random random = new Random(13 * seed + 5);
        random.nextLong();
        double grip = 1 + hardness * GRIP_RANGE * (2 * random.nextDouble() - 1);
        double mass = 1 + hardness * MASS_RANGE * (2 * random.nextDouble() - 1);
        Rehearsal robot = fallen.again(grip, mass);
        if (hardness > 0) {
            robot.with(new Disturbance(seed, hardness * PUSH_NEWTONS));
        }
        robot.begin(false);
        return GetUpTrial.run(robot, motion, settlingSeconds);
    }

    /**
     * Looks how it lies.
     *
     * @param side a side
     * @return whether it lies on that side
     */
    public boolean lies(Lying side) {
        return side.isTrueOf(fallen.again(1, 1).body());
    }
}
