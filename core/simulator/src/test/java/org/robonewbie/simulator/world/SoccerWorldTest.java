package org.robonewbie.simulator.world;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.ref.WeakReference;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.simulator.physics.BodyPose;

class SoccerWorldTest {

    private final SoccerWorld world = new SoccerWorld(SoccerField.LEAGUE);

    @Test
    void newRobotAppearsUprightInTheAirAndFalls() {
        Robot robot = world.addRobot(RobotType.TYPE_0);

        assertThat(robot.torso().position()).isEqualTo(new Vector3(0, -1, 1.5));
        assertThat(robot.torso().rotation().zz()).isEqualTo(1);

        step(10);
        assertThat(robot.torso().position().z()).isLessThan(1.3);
    }

    @Test
    void robotsAreListedInTheOrderOfAdding() {
        Robot first = world.addRobot(RobotType.TYPE_4);
        Robot second = world.addRobot(RobotType.TYPE_1);
        Robot third = world.addRobot(RobotType.TYPE_0);

        world.removeRobot(second);

        assertThat(world.robots()).containsExactly(first, third);
    }

    @Test
    void robotThatHasLeftIsForgottenAlthoughItTouchedTheGround() {
        List<WeakReference<Robot>> gone = new ArrayList<>();
        for (int i = 0; i < 3; i++) {
            Robot robot = standing(RobotType.TYPE_0, -3, 0);
            step(20);
            world.removeRobot(robot);
            gone.add(new WeakReference<>(robot));
        }
        step(2);

        System.gc();

        assertThat(gone).extracting(WeakReference::get).containsOnlyNulls();
    }

    @ParameterizedTest
    @EnumSource
    void everyRobotTypeStandsAndFeelsItsWeight(RobotType type) {
        Robot robot = standing(type, -3, 0);
        for (int i = 0; i < 50; i++) {
            robot.wake();
            world.step();
        }

        double weight =
                robot.nao().links().stream().mapToDouble(link -> link.massKg()).sum() * 9.81;
        double felt = Stream.of(
                        robot.footForces().left(),
                        robot.footForces().right(),
                        robot.footForces().leftToe(),
                        robot.footForces().rightToe())
                .flatMap(Optional::stream)
                .mapToDouble(force -> force.force().z())
                .sum();
        assertThat(robot.torso().rotation().zz()).isGreaterThan(0.9999);
        assertThat(felt / weight).isBetween(0.999, 1.001);
    }

    @Test
    void fallingForwardTurnsNegativeAboutTheRightAxis() {
        Robot robot = standing(RobotType.TYPE_0, 0, 0);
        robot.push(new Vector3(300, 0, 0));
        step(5);

        assertThat(robot.gyroDegreesPerSecond().x()).isLessThan(-10);
    }

    @Test
    void restingRobotSleepsUntilItMoves() {
        Robot robot = standing(RobotType.TYPE_0, 0, 0);
        boolean asleep = robot.isAsleep();
        Vector3 leftForce = robot.footForces().left().orElseThrow().force();
        step(1);

        robot.setMotorSpeed(Joint.NECK_YAW, 0);
        step(1);
        boolean asleepAfterZero = robot.isAsleep();
        robot.setMotorSpeed(Joint.NECK_YAW, 1);
        step(1);

        assertThat(asleep).isTrue();
        assertThat(leftForce.z()).isGreaterThan(20);
        assertThat(asleepAfterZero).isTrue();
        assertThat(robot.isAsleep()).isFalse();
    }

    @Test
    void ballThatMeetsARobotIsReportedAndThrownBack() {
        Robot robot = standing(RobotType.TYPE_0, 0, 0);
        world.ball().place(new Vector3(1, -0.05, 0.3));
        world.ball().setVelocity(new Vector3(-5, 0, 0));
        List<Robot> touched = new ArrayList<>();
        for (int i = 0; i < 20; i++) {
            world.step();
            world.ballTouches().forEach(part -> touched.add(part.robot()));
        }

        assertThat(touched).contains(robot);
        assertThat(world.ball().velocity().x()).isPositive();
    }

    @Test
    void robotsThatMeetAreReportedWithTheirParts() {
        Robot left = standing(RobotType.TYPE_0, -0.12, 0);
        Robot right = world.addRobot(RobotType.TYPE_0);
        right.moveUpright(new Vector3(0.12, 0, 0.4), 90);
        world.step();

        assertThat(world.robotContacts()).isNotEmpty().allSatisfy(contact -> {
            assertThat(List.of(contact.first().robot(), contact.second().robot()))
                    .containsExactlyInAnyOrder(left, right);
            assertThat(contact.position().z()).isBetween(0.0, 0.7);
        });
    }

    @Tag("slow")
    @Test
    @Timeout(120)
    void manyRobotsThatArePutIntoEachOtherComeApartInTime() {
        SoccerWorld pitch = new SoccerWorld(SoccerField.LEAGUE);
        for (int i = 0; i < 11; i++) {
            Robot robot = pitch.addRobot(RobotType.values()[i % 3]);
            robot.moveUpright(new Vector3(-0.5 + 0.01 * (i % 4), 0.4 + 0.01 * (i % 3), 0.4), -90);
        }

        for (int i = 0; i < 60; i++) {
            pitch.step();
        }

        double span = pitch.robots().stream()
                .mapToDouble(robot -> robot.torso().position().distanceTo(new Vector3(-0.5, 0.4, 0.4)))
                .max()
                .orElseThrow();
        assertThat(span).isBetween(0.2, 5.0);
    }

    @Test
    void removedRobotIsInNobodysWay() {
        Robot robot = standing(RobotType.TYPE_0, 0, 0);
        world.removeRobot(robot);
        world.ball().place(new Vector3(1, -0.05, 0.3));
        world.ball().setVelocity(new Vector3(-8, 0, 1));
        step(20);

        assertThat(world.ball().position().x()).isLessThan(-0.2);
        assertThat(world.robots()).isEmpty();
    }

    @Test
    void partsOfOneRobotDoNotTouchEachOther() {
        Robot robot = world.addRobot(RobotType.TYPE_0);
        robot.moveTo(new Vector3(0, 0, 50));
        robot.setMotorSpeed(Joint.LEFT_HIP_ROLL, -1);
        robot.setMotorSpeed(Joint.RIGHT_HIP_ROLL, 1);
        step(20);

        assertThat(robot.jointDegrees(Joint.LEFT_HIP_ROLL)).isLessThan(-20);
        assertThat(world.robotContacts()).isEmpty();
    }

    @Test
    void lastBeamBeforeAStepCounts() {
        Robot robot = standing(RobotType.TYPE_0, 0, 0);
        robot.beam(new Vector3(3, 3, 0.4), 0);
        robot.beam(new Vector3(-2, 1, 0.4), 90);

        Vector3 before = robot.torso().position();
        world.step();

        assertThat(before.x()).isBetween(-0.01, 0.01);
        assertThat(robot.torso().position().distanceTo(new Vector3(-2, 1, 0.4))).isLessThan(0.005);
        assertThat(robot.torso().rotation().axisY().x()).isLessThan(-0.999);
    }

    @Test
    void movingTwiceWithinACycleEndsAtTheLastPlace() {
        Robot robot = standing(RobotType.TYPE_0, 0, 0);
        robot.moveUpright(new Vector3(1, 1, 0.4), 30);
        robot.moveUpright(new Vector3(2, 2, 0.4), 60);
        robot.moveTo(new Vector3(3, 3, 0.5));

        assertThat(robot.torso().position().distanceTo(new Vector3(3, 3, 0.5))).isLessThan(1e-9);
        assertThat(robot.linkPose(robot.nao().linkIndex("head")).position().distanceTo(new Vector3(3, 3, 0.655)))
                .isLessThan(1e-3);
    }

    @Test
    void boundingBoxHoldsTheStandingRobot() {
        Robot robot = standing(RobotType.TYPE_0, 0, 0);

        assertThat(robot.boundingBox().min().z()).isBetween(-0.01, 0.01);
        assertThat(robot.boundingBox().max().z()).isBetween(0.59, 0.61);
        assertThat(robot.boundingBox().max().y() - robot.boundingBox().min().y())
                .isBetween(0.28, 0.3);
    }

    @Test
    void equalCommandsGiveBitIdenticalWorlds() {
        List<BodyPose> first = thrash(new SoccerWorld(SoccerField.LEAGUE));
        List<BodyPose> second = thrash(new SoccerWorld(SoccerField.LEAGUE));

        assertThat(second).isEqualTo(first);
    }

    /** Two robots and a ball close together, all joints moved at random: falls, contacts, stops. */
    private static List<BodyPose> thrash(SoccerWorld world) {
        SplittableRandom random = new SplittableRandom(11);
        Robot one = world.addRobot(RobotType.TYPE_0);
        Robot two = world.addRobot(RobotType.TYPE_4);
        one.moveUpright(new Vector3(-0.2, 0, 0.4), -90);
        two.moveUpright(new Vector3(0.2, 0.1, 0.4), 90);
        List<BodyPose> poses = new ArrayList<>();
        for (int i = 0; i < 200; i++) {
            for (Robot robot : world.robots()) {
                for (int j = 0; j < robot.nao().hinges().size(); j++) {
                    robot.setMotorSpeed(j, 4 * random.nextDouble() - 2);
                }
            }
            world.step();
            world.robots().forEach(robot -> poses.add(robot.torso()));
            poses.add(new BodyPose(world.ball().position(), world.ball().rotation()));
        }
        return poses;
    }

    private Robot standing(RobotType type, double x, double y) {
        Robot robot = world.addRobot(type);
        double drop = type == RobotType.TYPE_1 || type == RobotType.TYPE_3 ? 0.45 : 0.4;
        robot.moveUpright(new Vector3(x, y, drop), -90);
        step(100);
        return robot;
    }

    private void step(int count) {
        for (int i = 0; i < count; i++) {
            world.step();
        }
    }
}
