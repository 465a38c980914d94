package org.robonewbie.examples;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import java.util.ServiceLoader;
import org.junit.jupiter.api.Test;
import org.robonewbie.agent.Nao;
import org.robonewbie.agent.Options;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.protocol.embedded.EmbeddedSimulator;
import org.robonewbie.protocol.embedded.SimulatorProvider;
import org.robonewbie.protocol.embedded.SimulatorRequest;

/** Robots that join a running simulator through its port. */
class JoiningTest {

    @Test
    void aRobotJoinsByTcpAndMoves() throws Exception {
        try (EmbeddedSimulator simulator = simulator();
                Nao nao =
                        Nao.connect(at(simulator).withTeam("Blue").withNumber(3).withSeconds(1))) {
            nao.setJointAngle(Joint.NECK_YAW, 40);
            while (nao.sense()) {
                nao.act();
            }

            assertThat(nao.getNumber()).isEqualTo(3);
            assertThat(nao.getTeamSide()).isEqualTo(TeamSide.LEFT);
            assertThat(nao.getJointAngle(Joint.NECK_YAW)).isBetween(39.9, 40.1);
        }
    }

    @Test
    void aRobotNoticesThatTheSimulatorHasEnded() throws Exception {
        EmbeddedSimulator simulator = simulator();
        try (Nao nao = Nao.connect(at(simulator))) {
            boolean before = nao.sense();
            nao.act();

            simulator.close();
            boolean after = true;
            for (int i = 0; i < 5 && after; i++) {
                after = nao.sense();
                nao.act();
            }

            assertThat(before).isTrue();
            assertThat(after).isFalse();
        }
    }

    private static Options at(EmbeddedSimulator simulator) {
        return Options.none().with("host", "127.0.0.1").with("port", Integer.toString(simulator.agentPort()));
    }

    private static EmbeddedSimulator simulator() throws Exception {
        SimulatorProvider provider =
                ServiceLoader.load(SimulatorProvider.class).findFirst().orElseThrow();
        return provider.start(new SimulatorRequest(
                "NAO",
                0,
                OptionalLong.of(1),
                true,
                OptionalDouble.empty(),
                true,
                false,
                false,
                Optional.empty(),
                Optional.empty(),
                Optional.empty(),
                1,
                "Ada"));
    }
}
