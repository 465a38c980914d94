package org.robonewbie.learning.policy;

import java.util.Locale;
import java.util.Random;
import org.robonewbie.agent.walk.PolicyWalk;
import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.learning.motion.ScriptedMotors;
import org.robonewbie.learning.motion.ScriptedRobot;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.WorldState;

/**
 * A dash from the stance, straight ahead as fast as the walk can.
 *
 * @param metres how far the robot got on its feet
 * @param seconds how long it took
 * @param fallen whether it fell before the end
 */
public record WalkDash(double metres, double seconds, boolean fallen) {

    private static final double SLOWEST_METRES_PER_SECOND = 0.2;

    /** Runs until the robot has gone the way, has fallen, or is much too slow. */
    static WalkDash run(Trial room, PolicyWalk walk, long seed, double newtons, double metres) {
        ScriptedRobot student = new ScriptedMotors(walk);
        room.reset(seed, student.controller());
        student.walk(new WalkVelocity(walk.style().most().forward(), 0, 0));
        Pose2d start = room.now().place();
        WorldState now = room.now();
        HandPushes pushes = new HandPushes(new Random(seed), newtons);
        int cycle = 0;
        while (!now.robot().isFallen()
                && start.ahead(now.robot().position()) < metres
                && now.seconds() < metres / SLOWEST_METRES_PER_SECOND) {
            pushes.act(room, cycle++);
            now = room.step();
        }
        return new WalkDash(
                start.ahead(now.robot().position()), now.seconds(), now.robot().isFallen());
    }

    /** {@return metres per second over the whole way, the start included} */
    public double speed() {
        return metres / seconds;
    }

    @Override
    public String toString() {
        return String.format(
                Locale.ROOT, "%.2f m in %.2f s, %.3f m/s%s", metres, seconds, speed(), fallen ? ", fallen" : "");
    }
}
