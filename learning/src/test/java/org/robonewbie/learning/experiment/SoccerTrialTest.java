package org.robonewbie.learning.experiment;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.BodyPart;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;

class SoccerTrialTest {

    private static final double[] REST = new double[Joint.COUNT];

    @Test
    void robotStandsWhenATrialBegins() {
        Trial trial = new SoccerTrial(TrialSetting.standing().withSpread(0, 0, 0));

        for (int i = 0; i < 100; i++) {
            trial.step(REST);
        }

        RobotState robot = trial.state().robot();
        assertThat(trial.state().seconds()).isEqualTo(2);
        assertThat(robot.isFallen()).isFalse();
        assertThat(robot.tiltDegrees()).isLessThan(10);
        assertThat(robot.headingDegrees()).isCloseTo(0, within(3.0));
        assertThat(robot.position().distanceTo(new Vector3(1.5, 0, 0.36))).isLessThan(0.08);
        assertThat(robot.degrees(Joint.LEFT_KNEE_PITCH)).isCloseTo(-70, within(1.0));
    }

    @Test
    void commandActsOneCycleLaterThanItIsGiven() {
        Trial trial = new SoccerTrial(TrialSetting.standing());
        double[] nod = REST.clone();
        nod[Joint.NECK_YAW.ordinal()] = 100;
        double before = trial.state().robot().degrees(Joint.NECK_YAW);

        trial.step(nod);
        double after1 = trial.state().robot().degrees(Joint.NECK_YAW);
        trial.step(REST);
        double after2 = trial.state().robot().degrees(Joint.NECK_YAW);

        assertThat(after1).isCloseTo(before, within(0.01));
        assertThat(after2).isCloseTo(before + 2, within(0.05));
        assertThat(trial.state().robot().jointDegreesPerSecond()[Joint.NECK_YAW.ordinal()])
                .isCloseTo(100, within(2.0));
    }

    @Test
    void equalSeedsGiveEqualTrialsAndOthersOthers() {
        Trial used = new SoccerTrial(TrialSetting.standing());
        track(used, 3);

        assertThat(track(used, 7)).isEqualTo(track(new SoccerTrial(TrialSetting.standing()), 7));
        assertThat(track(used, 7)).isNotEqualTo(track(used, 8));
    }

    @Test
    void trialsInOtherThreadsDoNotDisturb() {
        List<List<Double>> alone = LongStream.range(0, 8)
                .mapToObj(seed -> track(new SoccerTrial(TrialSetting.standing()), seed))
                .toList();

        List<List<Double>> together = LongStream.range(0, 8)
                .parallel()
                .mapToObj(seed -> track(new SoccerTrial(TrialSetting.standing()), seed))
                .toList();

        assertThat(together).isEqualTo(alone);
    }

    @Test
    void severalRobotsObeyTheirOwnCommands() {
        Trial trial = new SoccerTrial(TrialSetting.standing()
                .withRobots(List.of(RobotStart.at(-1, 0), RobotStart.at(1, 0).facing(180))));
        double[] nod = REST.clone();
        nod[Joint.NECK_PITCH.ordinal()] = 60;

        for (int i = 0; i < 20; i++) {
            trial.step(REST, nod);
        }

        RobotState still = trial.state().robots().get(0);
        RobotState nodding = trial.state().robots().get(1);
        assertThat(nodding.degrees(Joint.NECK_PITCH) - still.degrees(Joint.NECK_PITCH))
                .isCloseTo(22.8, within(2.5));
        assertThat(Math.abs(nodding.headingDegrees())).isGreaterThan(175);
        assertThat(trial.robots()).isEqualTo(2);
    }

    @Test
    void observationHasANameForEachNumberAndLiesInItsRange() {
        Trial trial = new SoccerTrial(TrialSetting.standing());

        double[] seen = trial.observation(0);

        assertThat(seen).hasSize(trial.quantities().size());
        for (int i = 0; i < seen.length; i++) {
            ObservedQuantity quantity = trial.quantities().get(i);
            assertThat(seen[i]).as(quantity.name()).isBetween(quantity.least() - 1, quantity.greatest() + 1);
        }
        assertThat(value(trial, "accelerometer.up")).isCloseTo(9.81, within(1.0));
        assertThat(value(trial, "ball.inSight")).isEqualTo(1);
        assertThat(value(trial, "ball.distance")).isCloseTo(1.1, within(0.1));
        assertThat(value(trial, "leftFoot.force.up") + value(trial, "rightFoot.force.up"))
                .isCloseTo(4.6 * 9.81, within(5.0));
        assertThat(value(trial, "joint.LEFT_KNEE_PITCH"))
                .isCloseTo(trial.state().robot().degrees(Joint.LEFT_KNEE_PITCH), within(0.006));
    }

    @Test
    void robotThatSwaysIsSeenToFall() {
        Trial trial = new SoccerTrial(TrialSetting.standing());
        double[] bend = REST.clone();
        bend[Joint.LEFT_FOOT_PITCH.ordinal()] = -200;
        bend[Joint.RIGHT_FOOT_PITCH.ordinal()] = -200;

        for (int i = 0; i < 150; i++) {
            trial.step(bend);
        }

        assertThat(trial.state().robot().isFallen()).isTrue();
        assertThat(trial.state().robot().position(BodyPart.HEAD).z()).isLessThan(0.3);
        assertThat(trial.state().robot().centreOfMass().z()).isLessThan(0.2);
    }

    @Test
    void spreadMovesRobotAndBall() {
        SoccerTrial trial = new SoccerTrial(TrialSetting.standing().withSpread(0.2, 30, 0));
        List<Double> headings = new ArrayList<>();
        List<Double> balls = new ArrayList<>();

        for (long seed = 0; seed < 20; seed++) {
            trial.reset(seed);
            headings.add(trial.state().robot().headingDegrees());
            balls.add(trial.state().ballPosition().y());
        }

        assertThat(headings).anyMatch(degrees -> degrees > 10).anyMatch(degrees -> degrees < -10);
        assertThat(balls).anyMatch(metres -> metres > 0.08).anyMatch(metres -> metres < -0.08);
        assertThat(headings).allMatch(degrees -> Math.abs(degrees) < 35);
    }

    @Test
    void wrongCommandsAreRefusedWithAWordOnWhatToDo() {
        Trial trial = new SoccerTrial(TrialSetting.standing());
        double[] speeds = REST.clone();
        speeds[Joint.LEFT_KNEE_PITCH.ordinal()] = Double.NaN;

        assertThatThrownBy(() -> trial.step(speeds))
                .hasMessage("Joint speed NaN for LEFT_KNEE_PITCH of robot 0. Was something divided by zero?");
        assertThatThrownBy(() -> trial.step(REST, REST))
                .hasMessage("Commands for 2 robots, but the trial has 1. Give step() one array for each robot.");
        assertThatThrownBy(() -> trial.step(new double[3]))
                .hasMessage("Robot 0 gets 3 joint speeds, but it has 22 joints. "
                        + "Give one speed for each Joint in its order.");
        assertThatThrownBy(() -> TrialSetting.standing().withRobots(List.of()))
                .hasMessage("A trial without robots: give at least one RobotStart.");
    }

    private static double value(Trial trial, String name) {
        int index =
                trial.quantities().stream().map(ObservedQuantity::name).toList().indexOf(name);
        return trial.observation(0)[index];
    }

    /** What a robot with random commands perceives and where it is. */
    private static List<Double> track(Trial trial, long seed) {
        trial.reset(seed);
        Random random = new Random(seed);
        List<Double> track = new ArrayList<>();
        for (int i = 0; i < 60; i++) {
            trial.step(random.doubles(Joint.COUNT, -100, 100).toArray());
            Arrays.stream(trial.observation(0)).forEach(track::add);
            track.add(trial.state().robot().position().x());
        }
        return track;
    }
}
