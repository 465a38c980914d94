package org.robonewbie.robot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.kinematics.ForwardKinematics;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.model.Link;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.Posture;

class NaoRobotTest {

    @ParameterizedTest
    @EnumSource(RobotType.class)
    void massesAreThoseOfTheNao(RobotType type) {
        RobotModel robot = NaoRobot.of(type);
        List<Link> links = NaoModel.of(type).links();

        assertThat(robot.bodies())
                .extracting(RobotBody::name)
                .isEqualTo(links.stream().map(Link::name).toList());
        assertThat(robot.bodies())
                .extracting(RobotBody::massKg)
                .isEqualTo(links.stream().map(Link::massKg).toList());
        assertThat(robot.massKg()).isEqualTo(4.6071, within(1e-9));
    }

    @ParameterizedTest
    @EnumSource(RobotType.class)
    void rangesAndNamesOfJointsAreThoseThatStudentsType(RobotType type) {
        RobotModel robot = NaoRobot.of(type);

        for (Joint joint : Joint.values()) {
            RobotJoint data = robot.joint(joint.name()).orElseThrow();
            assertThat(data).isEqualTo(robot.joint(joint.effectorName()).orElseThrow());
            assertThat(data).isEqualTo(robot.joint(joint.perceptorName()).orElseThrow());
            assertThat(data.minDegrees()).isEqualTo(joint.minDegrees());
            assertThat(data.maxDegrees()).isEqualTo(joint.maxDegrees());
        }
        assertThat(robot.joints()).hasSize(Joint.COUNT + (type.hasToes() ? 2 : 0));
    }

    @ParameterizedTest
    @EnumSource(RobotType.class)
    void bodiesAreWhereTheForwardKinematicsOfTheNaoPutsThem(RobotType type) {
        RobotModel robot = NaoRobot.of(type);
        Random random = new Random(7);
        Posture posture = Posture.ZERO;
        for (Joint joint : Joint.values()) {
            double share = random.nextDouble();
            posture = posture.with(joint, joint.minDegrees() + share * (joint.maxDegrees() - joint.minDegrees()));
        }
        double[] degrees = new double[robot.joints().size()];
        for (Joint joint : Joint.values()) {
            degrees[robot.joint(joint.name()).orElseThrow().index()] = posture.degrees(joint);
        }

        List<Pose> poses = robot.bodyPoses(degrees);

        List<Pose> links = ForwardKinematics.of(type).poses(posture).links();
        for (int i = 0; i < links.size(); i++) {
            assertThat(poses.get(i).position().distanceTo(links.get(i).position()))
                    .as("distance of body %s", robot.bodies().get(i).name())
                    .isLessThan(1e-9);
        }
    }

    @ParameterizedTest
    @EnumSource(RobotType.class)
    void solesTouchTheGroundInTheStance(RobotType type) {
        RobotModel robot = NaoRobot.of(type);

        double lowest = lowestPoint(robot);

        assertThat(lowest).isEqualTo(0, within(1e-9));
    }

    private static double lowestPoint(RobotModel robot) {
        List<Pose> poses = robot.bodyPoses(robot.stanceDegrees());
        return robot.stanceHeight()
                + Arrays.stream(new String[] {"lfoot", "rfoot"})
                        .mapToInt(robot::bodyIndex)
                        .mapToDouble(foot -> poses.get(foot).position().z()
                                - robot.bodies()
                                                .get(foot)
                                                .shapes()
                                                .get(0)
                                                .shape()
                                                .size()
                                                .z()
                                        / 2)
                        .min()
                        .orElseThrow();
    }
}
