package org.robonewbie.agent;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.robonewbie.nao.Cycle;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.robot.BoosterT1;
import org.robonewbie.robot.RobotJoint;
import org.robonewbie.robot.RobotModel;

/**
 * Runs a program as a T1, and finds out what the robot cannot do. The ball is shot at the robot, then far away, nearby, at its feet,
 * and finally ahead on its right or left.
 */
public final class ExamplesOnT1 {

    /** Number of messages that a program receives: 48 s. */
    public static final int CYCLES = 2400;

    private static final RobotModel T1 = BoosterT1.MODEL;
    private static final Ball SHOT = new Ball(3.5, 0.5, 4);
    private static final int SHOT_CYCLE = 100;
    private static final int CYCLES_OF_SHOT = 40;
    private static final List<Ball> BALLS = List.of(
            new Ball(1.4, 3.8, 0),
            new Ball(3, 0.5, 0),
            new Ball(0.48, 0.17, 0),
            new Ball(0.52, 0.04, 0),
            new Ball(3.8, 3.2, 0));
    private static final double HEAD_METRES = 1.1;
    private static final String LANDMARKS =
            "(g_rup (pol 54.8 1.9 0.8))(g_rlp (pol 54.8 -1.9 0.8))(l_ruf (pol 57.6 18.2 -1.1))"
                    + "(l_rlf (pol 57.6 -18.2 -1.1))(P (team Red)(id 3)(head (pol 4.0 30.0 1.0)))"
                    + "(P (team Blue)(id 2)(head (pol 3.0 -30.0 1.0)))";
    private static final Map<String, String> RESTRICTIONS = restrictions();

    private ExamplesOnT1() {}

    private static Map<String, String> restrictions() {
        Map<String, String> restrictions = new LinkedHashMap<>();
        restrictions.put("commands and motions for its legs are ignored", "its motions of the legs");
        restrictions.put("has no force sensors in its feet", "the force on its feet, which is 0");
        restrictions.put("can say at most 10 characters", "what it says, which is too long");
        return restrictions;
    }

    /**
     * Plays on a scripted server, on which joints reach their targets immediately.
     *
     * @param agent the program
     * @return what of the program does not play on a T1
     */
    public static String missing(Agent agent) {
        return missing(reports(agent, new OnPaper()));
    }

    /**
     * Finds what does not play on a T1.
     *
     * @param reports what the framework has reported
     * @return the restrictions; empty if there are none
     */
    public static String missing(List<String> reports) {
        return RESTRICTIONS.entrySet().stream()
                .filter(restriction -> reports.stream().anyMatch(report -> report.contains(restriction.getKey())))
                .map(Map.Entry::getValue)
                .collect(Collectors.joining("; "));
    }

    /**
     * Plays until the server sends no more.
     *
     * @param agent the program
     * @param link connection to the server
     * @return what the framework reported, oldest first
     */
    public static List<String> reports(Agent agent, AgentLink link) {
        AgentDriver driver = new AgentDriver(agent);
        try {
            driver.joinLeague(link, driver.defaultOptions().withTeam("Blue").overriddenBy("--robot", "T1"));
            driver.resume();
        } catch (IOException impossible) {
            throw new UncheckedIOException(impossible);
        }
        return agent.runtime().diagnostics().reported();
    }

    /**
     * A ball.
     *
     * @param ahead metres ahead of the robot
     * @param left metres to its left
     * @param approach metres per second with which it rolls past the robot
     */
    public record Ball(double ahead, double left, double approach) {}

    /**
     * Returns where the script puts the ball.
     *
     * @param cycle number of the message
     * @return the ball
     */
    public static Ball ball(int cycle) {
        boolean isShot = cycle >= SHOT_CYCLE && cycle < SHOT_CYCLE + CYCLES_OF_SHOT;
        return isShot ? SHOT : BALLS.get(cycle * BALLS.size() / (CYCLES + 1));
    }

    /** Connection to a server that only exists on paper. */
    private static final class OnPaper implements AgentLink {

        private final double[] degrees = new double[T1.joints().size()];
        private int cycle;

        @Override
        public void send(MessageBuffer message) {
            String text = message.toString();
            for (RobotJoint joint : T1.joints()) {
                Pattern.compile("\\(" + joint.effectorName() + " ([-.\\d]+) ")
                        .matcher(text)
                        .results()
                        .forEach(found -> degrees[joint.index()] = Double.parseDouble(found.group(1)));
            }
        }

        @Override
        public boolean receive(MessageBuffer message) {
            if (++cycle > CYCLES) {
                return false;
            }
            Ball ball = ball(cycle);
            double ahead = ball.ahead - Math.max(0, cycle - SHOT_CYCLE) * Cycle.SECONDS * ball.approach;
            double metres = Math.hypot(ahead, ball.left);
            double turned = ball.ahead < 3.8 ? 0 : cycle % 480 / 6.0; // the last ball sweeps to the right
            message.clear();
            message.append(String.format(
                    Locale.ROOT,
                    "(time (now %.2f))(GS (t %.1f)(pm %s)(tl Blue)(tr Red)(sl 0)(sr 0))(GYR (n torso_gyro) (rt 0 0 0))"
                            + "(ACC (n torso_acc) (a 0 0 9.81))",
                    cycle * 0.02,
                    cycle * 0.02,
                    cycle < 120 ? "BeforeKickOff" : "PlayOn"));
            for (RobotJoint joint : T1.joints()) {
                message.append("(HJ (n " + joint.perceptorName() + ")(ax " + degrees[joint.index()] + ")(vx 0.0))");
            }
            if (cycle % 2 == 0) {
                message.append(String.format(
                        Locale.ROOT,
                        "(See %s(B (pol %.1f %.1f %.1f)))(MIC mic (30 aGFsbG8=))",
                        LANDMARKS,
                        Math.hypot(metres, HEAD_METRES),
                        Math.toDegrees(Math.atan2(ball.left, ahead)) - turned,
                        -Math.toDegrees(Math.atan2(HEAD_METRES, metres))));
            }
            return true;
        }

        @Override
        public void close() {
            // nothing to close
        }
    }
}
