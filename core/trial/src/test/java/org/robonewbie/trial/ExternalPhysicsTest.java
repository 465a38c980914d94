package org.robonewbie.trial;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.perceptor.FootForce;
import org.robonewbie.protocol.perceptor.FootForces;
import org.robonewbie.simulator.physics.BodyPose;
import org.robonewbie.simulator.world.LinkMotion;
import org.robonewbie.simulator.world.Robot;

class ExternalPhysicsTest {

    private static final Scene SCENE = Scene.of(RobotStart.at(-2, 0)).withBall(-1, 0);

    @Test
    void robotIsWhereTheOtherEnginePlacesItAndSensesWhatItComputes() {
        FootForce left = new FootForce(new Vector3(0, 0.01, 0), new Vector3(0, 0, 20));
        try (Trial trial = Trial.direct(SCENE, 1, Controller.ofSpeeds())) {
            double height = trial.robot(0).torso().position().z();
            trial.setPhysics((robot, ball, speeds) -> {
                robot.place(rising(robot));
                robot.setFootForces(
                        new FootForces(Optional.of(left), Optional.empty(), Optional.empty(), Optional.empty()));
                ball.place(new Vector3(3, 0, 0));
            });

            trial.step();
            WorldState now = trial.step();
            trial.step();

            assertThat(now.robot().position().z()).isCloseTo(height + 0.02, within(1e-9));
            assertThat(now.ball().x()).isEqualTo(3);
            assertThat(trial.readings(0).feet().left()).contains(left);
            assertThat(trial.readings(0).feet().right()).isEmpty();
            assertThat(trial.readings(0).acceleration().z()).isCloseTo(9.81 + 0.5 / Cycle.SECONDS, within(0.01));
        }
    }

    private static List<LinkMotion> rising(Robot robot) {
        return IntStream.range(0, robot.model().bodies().size())
                .mapToObj(robot::linkPose)
                .map(pose -> new BodyPose(pose.position().plus(new Vector3(0, 0, 0.01)), pose.rotation()))
                .map(pose -> new LinkMotion(pose, new Vector3(0, 0, 0.5), Vector3.ZERO))
                .toList();
    }

    @Test
    void otherEngineGetsSpeedsOfMotorsAndPushes() {
        List<double[]> speeds = new ArrayList<>();
        List<Vector3> pushes = new ArrayList<>();
        double[] wanted = new double[Joint.COUNT];
        wanted[Joint.NECK_YAW.ordinal()] = 90;
        try (Trial trial = Trial.direct(SCENE, 1, Controller.ofSpeeds(wanted))) {
            trial.with(world -> world.robot(0).push(new Vector3(7, 0, 0)));
            trial.setPhysics((robot, ball, radiansPerSecond) -> {
                speeds.add(radiansPerSecond);
                pushes.add(robot.externalForce());
            });

            trial.step();
            trial.step();
            trial.step();

            int neck = trial.robot(0).nao().hingeIndex(Joint.NECK_YAW);
            assertThat(speeds).allSatisfy(all -> assertThat(all[neck]).isCloseTo(Math.PI / 2, within(0.01)));
            assertThat(pushes).containsExactly(Vector3.ZERO, new Vector3(7, 0, 0), new Vector3(7, 0, 0));
        }
    }

    @Test
    void resetReturnsToThePhysicsOfTheSimulator() {
        try (Trial trial = Trial.direct(SCENE, 1, Controller.ofSpeeds());
                Trial other = Trial.direct(SCENE, 1, Controller.ofSpeeds())) {
            trial.setPhysics((robot, ball, speeds) -> robot.place(rising(robot)));
            trial.step();

            trial.reset(1, Controller.ofSpeeds());

            assertThat(trial.step().robot().torso())
                    .isEqualTo(other.step().robot().torso());
        }
    }

    @Test
    void severalRobotsAndServedTrialsAreRefused() {
        Scene two = Scene.of(RobotStart.at(-2, 0), RobotStart.at(2, 0).withTeam("Others", 1));
        try (Trial crowd = Trial.direct(two, 1, Controller.ofSpeeds(), Controller.ofSpeeds());
                Trial served = Trial.served(SCENE, 1, Controller.ofSpeeds())) {
            assertThatThrownBy(() -> crowd.setPhysics((robot, ball, speeds) -> {}))
                    .isInstanceOf(IllegalArgumentException.class)
                    .hasMessageContaining("this scene has 2");
            assertThatThrownBy(() -> served.setPhysics((robot, ball, speeds) -> {}))
                    .isInstanceOf(IllegalStateException.class)
                    .hasMessageContaining("Use a direct trial");
        }
    }
}
