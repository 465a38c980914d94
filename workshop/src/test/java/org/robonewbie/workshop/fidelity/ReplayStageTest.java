package org.robonewbie.workshop.fidelity;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.simulator.physics.BodyPose;

class ReplayStageTest {

    private static final double HALF_A_STEP_OF_FALLING = 0.01;

    @ParameterizedTest
    @CsvSource({
        "NONE, -14.2, 5.6, 1",
        "IN_PROCESS, -14.2, 5.6, 1",
        "TCP, -14.2, 9.2, 1",
        "TCP, 14.2, 9.2, -1",
        "IN_PROCESS, 14.2, 8.0, -1"
    })
    void theRobotJoinsAtThePlaceOfTheRecordedOne(AgentRoute route, double x, double y, double forwardX)
            throws IOException {
        JoiningWay way = new JoiningWay(3, new Vector3(x, y, 0.4), 60, 0);

        try (ReplayStage stage = ReplayStage.open(route, RobotType.TYPE_0, way)) {

            BodyPose torso = stage.robot().torso();
            assertThat(torso.position().distanceTo(way.place())).isLessThan(HALF_A_STEP_OF_FALLING);
            assertThat(torso.rotation().axisY().x()).isCloseTo(forwardX, within(1e-6));
        }
    }

    @ParameterizedTest
    @EnumSource(AgentRoute.class)
    void aBallStaysWhereItIsPut(AgentRoute route) throws IOException {
        JoiningWay way = new JoiningWay(3, new Vector3(-14.2, 9.2, 0.4), 60, 0);
        try (ReplayStage stage = ReplayStage.open(route, RobotType.TYPE_0, way)) {
            stage.placeBall(new Vector3(-3, 1, 0.042));

            for (int i = 0; i < 10; i++) {
                stage.step(List.of());
            }

            assertThat(stage.ball().position().distanceTo(new Vector3(-3, 1, 0.042)))
                    .isLessThan(0.002);
        }
    }
}
