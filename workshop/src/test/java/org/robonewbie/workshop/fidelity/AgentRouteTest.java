package org.robonewbie.workshop.fidelity;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Recordings of a real rcssserver3d, replayed by an agent that speaks with a whole server of ours. */
class AgentRouteTest {

    @ParameterizedTest
    @ValueSource(
            strings = {
                "b_stand_asleep_nonoise",
                "b_stand_noise",
                "b_stand_nonoise",
                "d_fall_back_nonoise",
                "d_fall_side_nonoise",
                "h_march_fast",
                "h_squat_50deg_1s",
                "f_ball_nonoise"
            })
    void anAgentOverTcpIsToldTheSameAsOneInTheProcessAndAsWasRecorded(String name) throws IOException {
        Recording recording = FidelityBench.readShipped(name + ".jsonl.gz");

        RecordingFidelity overTcp = Replay.of(recording, AgentRoute.TCP);
        RecordingFidelity inProcess = Replay.of(recording, AgentRoute.IN_PROCESS);

        assertThat(overTcp).isEqualTo(inProcess);
        assertThat(overTcp.firstDivergenceSeconds()).isEmpty();
        assertThat(overTcp.torsoMaxMetres().orElse(0)).isLessThan(1e-4);
        assertThat(List.of(overTcp.accRowsEqual(), overTcp.gyrRowsEqual(), overTcp.frpRowsEqual()))
                .filteredOn(OptionalDouble::isPresent)
                .allSatisfy(share -> assertThat(share.orElseThrow()).isGreaterThan(0.99));
    }

    @ParameterizedTest
    @ValueSource(strings = {"d_fall_front_nonoise", "h_squat_30deg_2s"})
    void theServerMovesTheTorsoExactlyAsTheBareWorldDoes(String name) throws IOException {
        Recording recording = FidelityBench.readShipped(name + ".jsonl.gz");

        RecordingFidelity inProcess = Replay.of(recording, AgentRoute.IN_PROCESS);
        RecordingFidelity bare = Replay.of(recording, AgentRoute.NONE);

        assertThat(inProcess.torsoMaxMetres().orElseThrow()
                        - bare.torsoMaxMetres().orElseThrow())
                .isBetween(-2e-7, 2e-7);
    }
}
