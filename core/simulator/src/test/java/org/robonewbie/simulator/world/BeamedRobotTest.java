package org.robonewbie.simulator.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.simulator.landscape.Landscape;
import org.robonewbie.simulator.physics.RotationMatrix;

/** Agents of the league beam their robot in each cycle until the kick-off, which may take minutes. */
class BeamedRobotTest {

    @ParameterizedTest
    @EnumSource
    void robotThatIsBeamedAgainAndAgainStaysWhole(PhysicsEngine engine) {
        SoccerWorld world =
                new SoccerWorld(SoccerField.LEAGUE, BallProperties.STANDARD, engine.newWorld(), Landscape.SOCCER);
        Robot robot = world.addRobot(RobotType.TYPE_0);

        for (int i = 0; i < 1000; i++) {
            robot.beam(new Vector3(-5, 2, 0.4), 7 * i);
            world.step();
            RotationMatrix turn = robot.torso().rotation();
            assertThat(turn.axisX().length()).isCloseTo(1, within(1e-11));
            assertThat(turn.axisY().dot(turn.axisZ())).isCloseTo(0, within(1e-11));
        }

        double feet = robot.linkPose(robot.nao().linkIndex("rfoot"))
                .position()
                .distanceTo(robot.torso().position());
        assertThat(feet).isCloseTo(0.38, within(0.02));
    }
}
