package org.robonewbie.simulator.cycle;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.Hinge;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.soccer.Player;
import org.robonewbie.simulator.state.WorldState;

/** Goes on from a hundred moments of whole games, with referee, fouls, noise and messages under way. */
class SimulationStateTest {

    private static final int MOMENTS_PER_SCENE = 34;
    private static final int STEPS = 220;
    private static final int STEPS_AFTER_MOMENT = 10;
    private static final int FIRST_MESSAGE = 2;

    /** What players and trainers do; the same at the same step, whatever happened before. */
    enum Scene {
        GAME(5, 1.1),
        PILE(4, 0.15),
        SET_PIECES(4, 2);

        private final int agents;
        private final double spread;

        Scene(int agents, double spread) {
            this.agents = agents;
            this.spread = spread;
        }

        /** What an agent sends in a step. */
        String commands(int agent, int step) {
            Random random = new Random(100_000L * ordinal() + 100L * step + agent);
            int number = 1 + agent / 2;
            if (step == 0) {
                return "(scene rsg/agent/nao/nao_hetero.rsg " + agent % 5 + ")(syn)";
            }
            if (step == 3) {
                return "(init (unum " + number + ")(teamname " + (agent % 2 == 0 ? "Ada" : "Bob") + "))(syn)";
            }
            String beam =
                    step == 8 ? "(beam " + (-0.3 - spread * number / 3) + " " + spread * (number - 2) + " 0)" : "";
            String word = step % 7 == agent ? "(say w" + step + ")" : "";
            String pass = step % 90 == 80 ? "(pass)" : "";
            List<Hinge> hinges = NaoModel.of(RobotType.TYPE_0).hinges();
            String hinge = hinges.get(random.nextInt(hinges.size())).effectorName();
            double speed = step < 40 ? 0 : 6 * random.nextDouble() - 3;
            return beam + word + pass + "(" + hinge + " " + speed + ")(syn)";
        }

        /** What happens to the world before a step. */
        void act(SteppedSimulator simulator, int step) {
            if (step == 45) {
                simulator.match().kickOff(TeamSide.LEFT);
            } else if (step == 60) {
                simulator.match().setPlayMode(this == SET_PIECES ? PlayMode.KICK_IN_LEFT : PlayMode.PLAY_ON);
            } else if (step % 40 == 30 && step > 60) {
                Player player = simulator.match().teams().players().get(step % agents);
                simulator.world().ball().place(player.position().plus(new Vector3(0.25, 0, 0)));
                simulator.world().ball().setVelocity(new Vector3(-6, this == SET_PIECES ? 9 : 0, 2));
            }
        }
    }

    /** A simulator with its agents. */
    private static final class Run {

        private final SteppedSimulator simulator =
                SteppedSimulator.start(WorldSettings.league().withNoise(true).withSeed(7), Console.silent());
        private final List<AgentLink> agents = new ArrayList<>();
        private final Scene scene;

        Run(Scene scene) {
            this.scene = scene;
            IntStream.range(0, scene.agents).forEach(i -> agents.add(simulator.connect()));
        }

        /** Runs a cycle and lists what the agents are told. */
        List<String> step(int step) throws IOException {
            scene.act(simulator, step);
            List<String> told = new ArrayList<>();
            MessageBuffer message = new MessageBuffer();
            for (int i = 0; i < agents.size(); i++) {
                message.clear();
                message.append(scene.commands(i, step));
                agents.get(i).send(message);
            }
            simulator.cycle();
            for (int i = 0; step >= FIRST_MESSAGE && i < agents.size(); i++) {
                assertThat(agents.get(i).receive(message)).isTrue();
                told.add(message.toString());
            }
            return told;
        }
    }

    @ParameterizedTest
    @EnumSource
    void anyMomentGoesOnToTheBit(Scene scene) throws IOException {
        Run uninterrupted = new Run(scene);
        List<WorldState> states = new ArrayList<>();
        List<List<String>> told = new ArrayList<>();
        for (int step = 0; step < STEPS; step++) {
            states.add(uninterrupted.simulator.save());
            told.add(uninterrupted.step(step));
        }
        Run reused = new Run(scene);
        Random random = new Random(scene.ordinal());

        for (int i = 0; i < MOMENTS_PER_SCENE; i++) {
            int moment = random.nextInt(STEPS - STEPS_AFTER_MOMENT);
            int end = moment + STEPS_AFTER_MOMENT;
            Run fresh = new Run(scene);
            reused.simulator.restore(states.get(moment));
            fresh.simulator.restore(WorldState.ofBytes(states.get(moment).toBytes()));
            for (int step = moment; step < end; step++) {
                assertThat(reused.step(step)).isEqualTo(told.get(step));
                assertThat(fresh.step(step)).isEqualTo(told.get(step));
            }

            assertThat(reused.simulator.save()).isEqualTo(states.get(end));
            assertThat(fresh.simulator.save()).isEqualTo(states.get(end));
            assertThat(fresh.simulator.report().recordingSha256())
                    .isEqualTo(reused.simulator.report().recordingSha256());
        }
        assertThat(uninterrupted.simulator.match().fouls().size()
                        + uninterrupted.simulator.match().state().score(TeamSide.LEFT))
                .as("things for the referee to remember")
                .isPositive();
    }

    @Test
    void anAnswerThatWasReadIsCarriedOutAfterwards() throws IOException {
        Run run = new Run(Scene.GAME);
        for (int step = 0; step < 60; step++) {
            run.step(step);
        }
        send(run, "(he1 2)(syn)");
        WorldState state = run.simulator.save();
        run.simulator.cycle();
        double turned = run.simulator.world().robots().get(0).jointDegrees(0);

        Run other = new Run(Scene.GAME);
        other.simulator.restore(state);
        other.simulator.cycle();

        assertThat(turned).isNotZero();
        assertThat(other.simulator.world().robots().get(0).jointDegrees(0)).isEqualTo(turned);
    }

    @Test
    void aMessageThatNobodyHasTakenWaitsAgain() throws IOException {
        Run run = new Run(Scene.GAME);
        for (int step = 0; step < 20; step++) {
            run.step(step);
        }
        send(run, "(syn)");
        run.simulator.cycle();
        WorldState state = run.simulator.save();
        List<String> waiting = receive(run);
        run.simulator.restore(state);

        assertThat(receive(run)).isEqualTo(waiting).doesNotContain("");
    }

    @Test
    void robotsOfAgentsThatAreNotThereStandStill() throws IOException {
        Run run = new Run(Scene.GAME);
        for (int step = 0; step < 30; step++) {
            run.step(step);
        }
        WorldState state = run.simulator.save();
        SteppedSimulator empty =
                SteppedSimulator.start(WorldSettings.league().withNoise(true).withSeed(7), Console.silent());

        empty.restore(state);
        for (int i = 0; i < 50; i++) {
            empty.cycle();
        }

        assertThat(empty.world().robots()).hasSize(Scene.GAME.agents);
        assertThat(empty.match().teams().players()).hasSize(Scene.GAME.agents);
    }

    @Test
    void agentsForWhomThereIsNoPlaceStayWithoutRobot() throws IOException {
        Run few = new Run(Scene.PILE);
        Run many = new Run(Scene.GAME);
        for (int step = 0; step < 30; step++) {
            few.step(step);
            many.step(step);
        }

        many.simulator.restore(few.simulator.save());
        List<String> told = many.step(30);

        assertThat(many.simulator.world().robots()).hasSize(Scene.PILE.agents);
        assertThat(told).hasSize(Scene.GAME.agents);
    }

    @Test
    void aStateOfAnotherGameIsRefused() {
        WorldState state = new Run(Scene.GAME).simulator.save();
        SteppedSimulator quiet = SteppedSimulator.start(WorldSettings.league().withNoise(false), Console.silent());

        assertThatIllegalArgumentException()
                .isThrownBy(() -> quiet.restore(state))
                .withMessage(
                        "The saved state belongs to a world with noise=true, but this one has noise=false. Start a world"
                                + " with the same settings.");
    }

    private static void send(Run run, String commands) throws IOException {
        MessageBuffer message = new MessageBuffer();
        message.append(commands);
        for (AgentLink agent : run.agents) {
            agent.send(message);
        }
    }

    private static List<String> receive(Run run) throws IOException {
        List<String> told = new ArrayList<>();
        MessageBuffer message = new MessageBuffer();
        for (AgentLink agent : run.agents) {
            agent.receive(message);
            told.add(message.toString());
        }
        return told;
    }
}
