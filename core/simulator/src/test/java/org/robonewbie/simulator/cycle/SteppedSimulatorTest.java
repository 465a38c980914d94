package org.robonewbie.simulator.cycle;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;

import java.io.IOException;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.landscape.Landscape;

class SteppedSimulatorTest {

    private static final String CREATE = "(scene rsg/agent/nao/nao.rsg)(syn)";

    private final SteppedSimulator simulator =
            SteppedSimulator.start(WorldSettings.beginner().withSeed(3), Console.silent());
    private final MessageBuffer message = new MessageBuffer();

    @Test
    void worldGoesOnWhenAnAgentWaitsForItsNextMessage() throws IOException {
        AgentLink agent = simulator.connect();

        send(agent, CREATE);
        boolean received = agent.receive(message);

        assertThat(received).isTrue();
        assertThat(simulator.cycles()).isEqualTo(3);
        assertThat(message.toString()).startsWith("(time (now 0.04))");
    }

    @Test
    void agentsTakeTurns() throws IOException {
        List<AgentLink> agents = List.of(simulator.connect(), simulator.connect());
        for (AgentLink agent : agents) {
            send(agent, CREATE);
        }

        for (int i = 0; i < 20; i++) {
            for (AgentLink agent : agents) {
                agent.receive(message);
                send(agent, "(he1 1)(syn)");
            }
        }

        assertThat(simulator.world().robots()).hasSize(2);
        assertThat(simulator.cycles()).isEqualTo(22);
    }

    @Test
    void equalRunsAmongThingsGiveEqualRecordings() throws IOException {
        WorldSettings among = WorldSettings.beginner().withSeed(3).withLandscape(Landscape.BOX);

        assertThat(hashOf(among)).isEqualTo(hashOf(among)).isNotEqualTo(hashOf(among.withLandscape(Landscape.SLOPE)));
    }

    private String hashOf(WorldSettings settings) throws IOException {
        SteppedSimulator one = SteppedSimulator.start(settings, Console.silent());
        AgentLink agent = one.connect();
        send(agent, CREATE);
        for (int i = 0; i < 30; i++) {
            agent.receive(message);
            send(agent, "(he1 1)(syn)");
        }
        return one.report().recordingSha256();
    }

    @Test
    void waitingAndSteppingGiveTheSameRun() throws IOException {
        AgentLink waiting = simulator.connect();
        SteppedSimulator other = SteppedSimulator.start(WorldSettings.beginner().withSeed(3), Console.silent());
        AgentLink stepping = other.connect();

        send(waiting, CREATE);
        waiting.receive(message);
        send(stepping, CREATE);
        other.cycle();
        other.cycle();
        other.cycle();
        stepping.receive(message);
        for (int i = 0; i < 50; i++) {
            send(waiting, "(lae1 1)(syn)");
            waiting.receive(message);
            send(stepping, "(lae1 1)(syn)");
            other.cycle();
            stepping.receive(message);
        }

        assertThat(simulator.report().recordingSha256())
                .isEqualTo(other.report().recordingSha256());
    }

    @Test
    void agentThatDoesNotAnswerIsNamedInsteadOfWaitedFor() throws IOException {
        AgentLink agent = simulator.connect();
        send(agent, CREATE);
        agent.receive(message);

        assertThatIllegalStateException()
                .isThrownBy(() -> agent.receive(message))
                .withMessage(
                        "The next cycle cannot start: an agent without a team (in this process) has not answered its last"
                                + " message. Let each agent of this thread answer before any agent waits.");
    }

    @Test
    void worldEndsByItself() throws IOException {
        AgentLink agent = simulator.connect();
        simulator.endAfter(0.2);
        send(agent, CREATE);

        int messages = 0;
        while (agent.receive(message)) {
            messages++;
            send(agent, "(syn)");
        }

        assertThat(simulator.cycles()).isEqualTo(10);
        assertThat(messages).isEqualTo(8);
    }

    @Test
    void agentThatLeavesTakesItsRobotAlong() throws IOException {
        AgentLink staying = simulator.connect();
        AgentLink leaving = simulator.connect();
        send(staying, CREATE);
        send(leaving, CREATE);
        staying.receive(message);

        leaving.close();
        for (int i = 0; i < 3; i++) {
            send(staying, "(syn)");
            staying.receive(message);
        }

        assertThat(simulator.world().robots()).hasSize(1);
    }

    private void send(AgentLink agent, String text) throws IOException {
        message.clear();
        message.append(text);
        agent.send(message);
    }
}
