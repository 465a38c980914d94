package org.robonewbie.agent.walk;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.robonewbie.agent.perception.TorsoMotion;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.ForwardKinematics;
import org.robonewbie.nao.kinematics.Leg;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.Posture;

class WalkEngineTest {

    private final WalkEngine engine = new WalkEngine(WalkStyle.STANDARD);

    @Test
    void keepsTheStanceWithoutAVelocity() {
        Posture posture = engine.next();

        assertThat(posture).isEqualTo(Stance.POSTURE);
        assertThat(engine.isStanding()).isTrue();
    }

    @Test
    void leavesTheStanceSoftly() {
        engine.towards(new WalkVelocity(10, 0, 0));

        Posture first = engine.next();

        assertThat(first.largestDifference(Stance.POSTURE)).isLessThan(5);
    }

    @Test
    void comesBackToTheStanceWithinTwoSecondsOfAStop() {
        engine.towards(new WalkVelocity(1, 0, 30));
        postures(engine, 200);

        engine.towards(WalkVelocity.ZERO);
        List<Posture> stopping =
                postures(engine, 100 + 2 * WalkStyle.STANDARD.gait().stepMillis() / 20);

        assertThat(engine.isStanding()).isTrue();
        assertThat(stopping.get(stopping.size() - 1).largestDifference(Stance.POSTURE))
                .isLessThan(1e-9);
    }

    @Test
    void walksToTheRightAsTheMirrorImageOfTheLeft() {
        WalkEngine other = new WalkEngine(WalkStyle.STANDARD);
        engine.towards(new WalkVelocity(0.1, 0.05, 20));
        other.towards(new WalkVelocity(0.1, -0.05, -20));

        List<Posture> left = postures(engine, 150);
        List<Posture> right = postures(other, 150);

        for (int i = 0; i < left.size(); i++) {
            assertThat(right.get(i).mirrored().largestDifference(left.get(i))).isLessThan(0.1);
        }
    }

    @Test
    void slowsDownToASlowerWalkWithoutAStop() {
        WalkVelocity most = new WalkVelocity(0.2, 0.1, 30);
        WalkStyle slow = WalkStyle.STANDARD.withLimits(most, 0.1, WalkStyle.STANDARD.change());
        WalkEngine slowFromTheStart = new WalkEngine(slow);
        WalkVelocity fast = new WalkVelocity(0.6, 0, 0);
        engine.towards(fast);
        slowFromTheStart.towards(fast);
        postures(engine, 200);

        engine.change(new PolicyWalk(slow, WalkReflex.NONE));
        engine.towards(fast);
        List<Posture> changing = postures(engine, 200);
        List<Posture> expected = postures(slowFromTheStart, 400);

        assertThat(changing.get(199).largestDifference(expected.get(399))).isLessThan(0.5);
        for (int i = 1; i < changing.size(); i++) {
            assertThat(changing.get(i).largestDifference(changing.get(i - 1))).isLessThan(15);
        }
    }

    @Test
    void anotherReflexOfTheSameStyleTakesEffectWithTheNextStep() {
        engine.towards(new WalkVelocity(0.2, 0, 0));
        postures(engine, 100);

        engine.change(new PolicyWalk(WalkStyle.STANDARD, (planned, moment) -> planned.with(Joint.NECK_YAW, 20)));

        assertThat(postures(engine, 50))
                .last()
                .extracting(posture -> posture.degrees(Joint.NECK_YAW))
                .isEqualTo(20.0);
    }

    @Test
    void movesItsFeetFromAsFarAheadToAsFarBehindAsItWalksInAStep() {
        double speed = 0.2;
        engine.towards(new WalkVelocity(speed, 0, 0));
        postures(engine, 200);

        DoubleSummaryStatistics leftFoot = postures(engine, 100).stream()
                .mapToDouble(WalkEngineTest::leftFootAhead)
                .summaryStatistics();

        double stepLength = speed
                * WalkStyle.STANDARD.slip().forward()
                * WalkStyle.STANDARD.gait().stepMillis()
                / 1000;
        assertThat(leftFoot.getMax() - leftFoot.getMin()).isCloseTo(stepLength, within(0.02));
    }

    @Test
    void slowsDownWhatNoRobotCanDo() {
        WalkVelocity possible = new WalkVelocity(30, 30, 0).within(new WalkVelocity(0.5, 0.5, 60), 0.3);

        assertThat(possible.forward()).isCloseTo(0.25, within(1e-9));
        assertThat(possible.left()).isCloseTo(0.25, within(1e-9));
    }

    @Test
    void feelsThatTheTorsoBows() {
        Balance balance = new Balance();
        TorsoMotion torso = TorsoMotion.AT_REST.withGyro(new Vector3(0, 20, 0));
        for (int i = 0; i < 25; i++) {
            balance.update(torso);
        }

        assertThat(balance.pitchDegrees()).isBetween(5.0, 10.0);
        assertThat(balance.rollDegrees()).isCloseTo(0, within(1e-9));
    }

    @Test
    void believesTheDirectionOfGravityInTheLongRun() {
        Balance balance = new Balance();
        TorsoMotion torso =
                TorsoMotion.AT_REST.withAcceleration(new Vector3(0, 9.81 * Math.sin(0.1), 9.81 * Math.cos(0.1)));
        for (int i = 0; i < 400; i++) {
            balance.update(torso);
        }

        assertThat(balance.rollDegrees()).isCloseTo(Math.toDegrees(0.1), within(0.1));
    }

    private static double leftFootAhead(Posture posture) {
        return ForwardKinematics.of(RobotType.TYPE_0)
                .poses(posture)
                .foot(Leg.LEFT)
                .position()
                .x();
    }

    private static List<Posture> postures(WalkEngine engine, int cycles) {
        List<Posture> postures = new ArrayList<>();
        for (int i = 0; i < cycles; i++) {
            engine.update(TorsoMotion.AT_REST);
            postures.add(engine.next());
        }
        return postures;
    }
}
