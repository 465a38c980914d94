package org.robonewbie.simulator.world;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.RobotType;

class WorldLimitsTest {

    private final SoccerWorld world = new SoccerWorld(SoccerField.LEAGUE);
    private final Robot robot = world.addRobot(RobotType.TYPE_0);

    @ParameterizedTest
    @ValueSource(doubles = {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY, 1e308, -1e30})
    void noNumberThatATrainerSendsStopsTheWorld(double nasty) {
        Vector3 vector = new Vector3(nasty, nasty, nasty);
        world.ball().moveTo(vector);
        world.ball().setVelocity(vector);
        robot.moveTo(vector);
        step(5);
        robot.moveUpright(vector, nasty);
        step(5);
        robot.beam(vector, nasty);
        robot.setMotorSpeed(3, nasty);
        step(5);

        robot.moveUpright(new Vector3(-3, 0, 0.4), 0);
        step(1);

        assertThat(robot.torso().position().distanceTo(new Vector3(-3, 0, 0.4))).isLessThan(0.05);
        assertThat(Double.isFinite(world.ball().position().length())).isTrue();
    }

    @ParameterizedTest
    @ValueSource(doubles = {Double.NaN, Double.POSITIVE_INFINITY, 1e308})
    void noPushTearsARobotApartForEver(double nasty) {
        for (int i = 0; i < 3; i++) {
            robot.push(new Vector3(nasty, 0, 0));
            step(5);
        }

        robot.moveUpright(new Vector3(-3, 0, 0.4), 0);
        step(50);

        assertThat(robot.torso().position().distanceTo(new Vector3(-3, 0, 0.385)))
                .isLessThan(0.5);
    }

    @Test
    void aBallThatIsShotAwayForEverComesBackToTheCentreSpot() {
        Vector3 last = world.ball().position();
        boolean cameBack = false;
        for (int i = 0; i < 60 && !cameBack; i++) {
            world.ball().setVelocity(new Vector3(0, 0, 1000));
            step(50);
            cameBack = world.ball().position().z() < last.z();
            last = world.ball().position();
        }

        assertThat(cameBack).isTrue();
    }

    private void step(int count) {
        for (int i = 0; i < count; i++) {
            world.step();
        }
    }
}
