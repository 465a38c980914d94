package org.robonewbie.simulator.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.simulator.landscape.Landscape;
import org.robonewbie.simulator.physics.sparse.SparsePhysicsWorld;

class BallTest {

    private final SoccerWorld world = new SoccerWorld(SoccerField.LEAGUE);
    private final Ball ball = world.ball();

    @Test
    void fallsWithGravityAndIsSlowedByTheAir() {
        ball.place(new Vector3(0, 0, 10));

        step(50);

        double speed = 0;
        double height = 10;
        for (int i = 0; i < 50; i++) {
            speed += 0.02 * (-9.81 - 0.01 * speed / 0.026);
            height += 0.02 * speed;
        }
        assertThat(ball.velocity().z()).isCloseTo(speed, within(1e-9));
        assertThat(ball.position().z()).isCloseTo(height, within(1e-9));
    }

    @Test
    void bouncesHalfAsHighAsTheRecordedOne() {
        ball.place(new Vector3(0, 0, 1));

        double highest = 0;
        boolean rising = false;
        for (int i = 0; i < 100; i++) {
            world.step();
            rising |= ball.velocity().z() > 0;
            highest = rising ? Math.max(highest, ball.position().z()) : highest;
        }

        assertThat(highest).isBetween(0.3, 0.7);
    }

    @Test
    void rollsAsFarAsTheRecordedOne() {
        ball.setVelocity(new Vector3(3, 0, 0));

        step(900);

        assertThat(ball.position().x()).isCloseTo(2.03098, within(1e-5));
    }

    @Test
    void rollingBallSpinsForward() {
        ball.setVelocity(new Vector3(2, 0, 0));

        step(40);

        assertThat(ball.spin().y()).isPositive();
    }

    @Test
    void movingKeepsVelocityAndSpin() {
        ball.setVelocity(new Vector3(2, 0, 0));
        step(40);
        Vector3 velocity = ball.velocity();
        Vector3 spin = ball.spin();

        ball.moveTo(new Vector3(1, 1, 1));

        assertThat(ball.position()).isEqualTo(new Vector3(1, 1, 1));
        assertThat(ball.velocity()).isEqualTo(velocity);
        assertThat(ball.spin()).isEqualTo(spin);
    }

    @Test
    void settingTheVelocityTakesAwayTheSpin() {
        ball.setVelocity(new Vector3(2, 0, 0));
        step(40);

        ball.setVelocity(new Vector3(0, 1, 0));

        assertThat(ball.velocity()).isEqualTo(new Vector3(0, 1, 0));
        assertThat(ball.spin()).isEqualTo(Vector3.ZERO);
    }

    @Test
    void aSleepingBallWakesWhenItIsPlaced() {
        step(200);
        double restingHeight = ball.position().z();

        ball.place(new Vector3(2, 0, 0.5));
        step(10);

        assertThat(restingHeight).isCloseTo(0.0403, within(1e-4));
        assertThat(ball.position().z()).isLessThan(0.4);
    }

    @Test
    void isReportedInsideTheGoalThatItRollsInto() {
        ball.place(new Vector3(14.9, 0, 0.042));
        ball.setVelocity(new Vector3(3, 0, 0));
        world.step();
        boolean before = world.isBallInGoal(TeamSide.RIGHT);

        step(15);

        assertThat(before).isFalse();
        assertThat(world.isBallInGoal(TeamSide.RIGHT)).isTrue();
        assertThat(world.isBallInGoal(TeamSide.LEFT)).isFalse();
    }

    @Test
    void doesNotPassThroughTheBackOfTheGoal() {
        ball.place(new Vector3(-14, 0.5, 0.3));
        ball.setVelocity(new Vector3(-8, 0, 1));

        double farthest = 0;
        for (int i = 0; i < 50; i++) {
            world.step();
            farthest = Math.min(farthest, ball.position().x());
        }

        assertThat(farthest).isBetween(-15.6, -15.3);
        assertThat(ball.velocity().x()).isPositive();
    }

    @Test
    void isThrownBackByTheOuterWalls() {
        ball.place(new Vector3(23, 0, 0.2));
        ball.setVelocity(new Vector3(10, 0, 1));

        step(60);

        assertThat(ball.position().x()).isLessThan(24.5);
        assertThat(ball.velocity().x()).isNegative();
    }

    @Test
    void ballOfAnotherSizeRestsOnItsRadius() {
        SoccerWorld other = new SoccerWorld(
                SoccerField.BEGINNER, new BallProperties(0.05, 0.042), new SparsePhysicsWorld(), Landscape.SOCCER);
        for (int i = 0; i < 200; i++) {
            other.step();
        }

        assertThat(other.ball().position().z()).isBetween(0.045, 0.05);
    }

    private void step(int count) {
        for (int i = 0; i < count; i++) {
            world.step();
        }
    }
}
