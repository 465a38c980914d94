package org.robonewbie.agent;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.regex.Pattern;
import org.robonewbie.agent.cycle.CycleWatch;
import org.robonewbie.agent.cycle.Session;
import org.robonewbie.agent.league.LeaguePlayer;
import org.robonewbie.agent.league.LeaguePort;
import org.robonewbie.agent.league.LearnedWalk;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.robot.BoosterT1;
import org.robonewbie.robot.RobotJoint;
import org.robonewbie.robot.RobotModel;

/**
 * Runs a program as a T1 against a scripted server. Joints reach their targets immediately; the ball is far away at first, then nearby,
 * then at the robot's feet, and finally on its way to the goal.
 */
public final class ExamplesOnT1 {

    private static final RobotModel T1 = BoosterT1.MODEL;
    private static final int CYCLES = 2400;
    private static final List<String> BALLS =
            List.of("4.0 70.0 -8.0", "3.0 10.0 -12.0", "0.9 20.0 -55.0", "0.9 5.0 -55.0", "5.0 %.1f -6.0");
    private static final String LANDMARKS =
            "(g_rup (pol 20.0 20.0 2.0))(g_rlp (pol 20.0 9.5 2.0))(l_ruf (pol 27.0 48.0 -1.0))"
                    + "(l_rlf (pol 24.0 -28.0 -1.0))(P (team Red)(id 3)(head (pol 4.0 30.0 1.0)))"
                    + "(P (team Blue)(id 2)(head (pol 3.0 -30.0 1.0)))";

    private ExamplesOnT1() {}

    /**
     * Plays for 48 s.
     *
     * @param agent the program
     * @return what the framework reported, oldest first
     */
    public static List<String> reports(Agent agent) {
        Options options = agent.defaults().withTeam("Blue").overriddenBy("--robot", "T1");
        agent.begin(options);
        LeaguePort port = new LeaguePort(
                new OnPaper(),
                agent.runtime(),
                new LeaguePlayer(T1, options.team(), Math.max(1, options.number())),
                LearnedWalk.of(T1, Optional.empty()),
                false);
        try {
            new StartDialogue(port, agent.runtime(), options).run(() -> {}, () -> {});
        } catch (IOException impossible) {
            throw new UncheckedIOException(impossible);
        }
        agent.run(new Session(agent.runtime(), port, OptionalDouble.of(1e9), CycleWatch.NONE));
        return agent.runtime().diagnostics().reported();
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
            String ball = BALLS.get(cycle * BALLS.size() / (CYCLES + 1));
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
                        "(See %s(B (pol " + ball + ")))(MIC mic (30 aGFsbG8=))",
                        LANDMARKS,
                        40 - cycle % 480 / 6.0));
            }
            return true;
        }

        @Override
        public void close() {
            // nothing to close
        }
    }
}
