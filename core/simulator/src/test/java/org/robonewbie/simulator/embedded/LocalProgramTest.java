package org.robonewbie.simulator.embedded;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.simulator.cycle.WorldSettings;
import org.robonewbie.simulator.server.Simulator;
import org.robonewbie.simulator.server.SimulatorSettings;

@Timeout(60)
class LocalProgramTest {

    @Test
    void simulatorGoesOnAfterAViewHasEndedTheProgram() throws IOException, InterruptedException {
        SimulatorSettings settings =
                SimulatorSettings.of(WorldSettings.beginner()).withAgentPort(0);
        Simulator simulator = Simulator.start(settings, sentence -> {});
        LocalProgram program = new LocalProgram(simulator, "MyAgent", "NAO", sentence -> {});
        AgentLink robot = program.connect();
        assertThat(program.isRunning()).isTrue();

        program.end();
        Thread waiting = new Thread(program::awaitReplacement);
        waiting.start();

        assertThat(robot.receive(new MessageBuffer())).isFalse();
        assertThat(program.isRunning()).isFalse();
        assertThat(simulator.report()).isEmpty();
        simulator.close();
        waiting.join();
    }
}
