package org.robonewbie.app.command;

import java.util.Arrays;
import java.util.OptionalDouble;
import java.util.stream.Stream;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.Robot;
import org.robonewbie.agent.perception.CameraPicture;
import org.robonewbie.examples.Agent_BetterSoccer;
import org.robonewbie.examples.Agent_SimpleSoccer;
import org.robonewbie.examples.Agent_SimpleWalkToBall;
import org.robonewbie.nao.Vector3;

/** Example agents that end as soon as they have done their task, and tell how long it took. */
final class TimedAgents {

    private static final double NEAR_METRES = 0.6;
    private static final double STANDING_SECONDS = 2;

    private TimedAgents() {}

    /** Ends a run with the robot's first goal and keeps the time. */
    private static final class FirstGoal {

        private double seconds = Double.NaN;

        boolean isAwaitedBy(Robot nao) {
            boolean scored = nao.getOwnScore() > 0;
            seconds = scored ? nao.getTime() : Double.NaN;
            return !scored;
        }
    }

    static OptionalDouble simpleSoccer(long seed) {
        FirstGoal goal = new FirstGoal();
        Agent agent = new Agent_SimpleSoccer() {
            @Override
            protected void sense() {
                super.sense();
                if (!goal.isAwaitedBy(nao)) {
                    leaveGame();
                }
            }
        };
        run(agent, seed, "1200");
        return optional(goal.seconds);
    }

    static OptionalDouble betterSoccer(long seed) {
        FirstGoal goal = new FirstGoal();
        Agent agent = new Agent_BetterSoccer() {
            @Override
            protected void sense() {
                super.sense();
                if (!goal.isAwaitedBy(nao)) {
                    leaveGame();
                }
            }
        };
        run(agent, seed, "300");
        return optional(goal.seconds);
    }

    /** The agent is there when it stands near the ball, in truth, for two seconds. */
    static OptionalDouble walkToBall(long seed, String pose) {
        double[] arrived = {Double.NaN};
        Agent agent = new Agent_SimpleWalkToBall() {
            @Override
            protected void sense() {
                super.sense();
                nao.getVision().flatMap(CameraPicture::truth).ifPresent(this::look);
                if (nao.getTime() - arrived[0] > STANDING_SECONDS) {
                    leaveGame();
                }
            }

            private void look(CameraPicture.Truth truth) {
                Vector3 head = truth.head();
                Vector3 ball = truth.ball();
                boolean near = Math.hypot(head.x() - ball.x(), head.y() - ball.y()) < NEAR_METRES;
                boolean standing =
                        !nao.isFallen() && motions.current().orElse("stand").equals("stand");
                if (!near || !standing) {
                    arrived[0] = Double.NaN;
                } else if (Double.isNaN(arrived[0])) {
                    arrived[0] = nao.getTime();
                }
            }
        };
        run(agent, seed, "180", "--truth", "--pose", pose);
        return optional(arrived[0]);
    }

    private static void run(Agent agent, long seed, String seconds, String... more) {
        String[] usual = {"--headless", "--fast", "--seed", Long.toString(seed), "--seconds", seconds};
        agent.run(Stream.of(usual, more).flatMap(Arrays::stream).toArray(String[]::new));
    }

    private static OptionalDouble optional(double seconds) {
        return Double.isNaN(seconds) ? OptionalDouble.empty() : OptionalDouble.of(seconds);
    }
}
