package org.robonewbie.trial;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.simulator.landscape.Landscape;
import org.robonewbie.simulator.recording.RecordingTarget;
import org.robonewbie.simulator.soccer.SoccerParameters;
import org.robonewbie.trial.measure.SustainedCondition;

class TrialTest {

    private static final Scene ALONE = Scene.of(RobotStart.at(-2, 0));
    private static final Scene TWO =
            Scene.of(RobotStart.at(-2, 0), RobotStart.at(2, 1).withTeam("Others", 7));

    @Test
    void robotsAndBallAreWhereTheSceneSays() {
        Scene scene = TWO.withBall(1, -1).withoutNoise();

        try (Trial trial = Trial.served(scene, 1, Controller.ofSpeeds(), Controller.ofSpeeds())) {
            WorldState state = trial.now();

            assertThat(state.place(0).x()).isCloseTo(-2, within(0.05));
            assertThat(state.place(1).y()).isCloseTo(1, within(0.05));
            assertThat(state.ball().distanceTo(new Vector3(1, -1, 0.042))).isLessThan(0.01);
            assertThat(trial.robot(1).body().position().x()).isCloseTo(2, within(0.05));
            assertThat(trial.snapshot(true, 1).robots()).hasSize(2);
        }
    }

    @Test
    void eachRobotNeedsAController() {
        assertThatThrownBy(() -> Trial.direct(TWO, 1, Controller.ofSpeeds()))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageStartingWith("1 controllers for 2 robots.");
        assertThatThrownBy(Scene::of)
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageStartingWith("The scene has no robots");
    }

    @Test
    void runEndsWithTheTimeOrTheMeasure() {
        try (Trial trial = Trial.direct(ALONE, 1, Controller.ofSpeeds())) {
            trial.run(0.5);
            assertThat(trial.seconds()).isCloseTo(0.5, within(1e-9));

            trial.run(3, new SustainedCondition(0.2, state -> true));
            assertThat(trial.seconds()).isCloseTo(0.7, within(0.021));
        }
    }

    @Test
    void hookActsAfterEachCycle() {
        List<Double> seconds = new ArrayList<>();

        try (Trial trial = Trial.direct(ALONE, 1, Controller.ofSpeeds())) {
            trial.with(hooked -> seconds.add(hooked.seconds())).run(0.06);
        }

        assertThat(seconds).hasSize(3).isSorted();
    }

    @Test
    void listenerHearsOfEachCycleFromTheEntryOn() {
        List<Double> cycles = new ArrayList<>();

        try (Trial trial = Trial.observed(
                ALONE, 1, heard -> cycles.add(heard.seconds()), RecordingTarget.NONE, start -> Controller.ofSpeeds())) {
            int entry = cycles.size();
            trial.run(0.1);

            assertThat(entry).isGreaterThan(20);
            assertThat(cycles).hasSize(entry + 5);
        }
    }

    @Test
    void robotIsMovedAndItsWordsAreKnown() {
        Controller speaker = readings -> List.of(new EffectorCommand.Say("hello"));

        try (Trial trial = Trial.served(ALONE, 1, speaker)) {
            assertThat(trial.said(0)).isEmpty();
            trial.moveRobot(0, new Pose2d(1, 0.5, 90));
            trial.step();

            assertThat(trial.said(0)).contains("hello");
            assertThat(trial.now().place().x()).isCloseTo(1, within(0.05));
            assertThat(trial.now().place().degrees()).isCloseTo(90, within(3.0));
        }
    }

    @Test
    void onlyADirectTrialIsReset() {
        try (Trial trial = Trial.served(ALONE, 1, Controller.ofSpeeds())) {
            assertThatThrownBy(() -> trial.reset(1, Controller.ofSpeeds()))
                    .isInstanceOf(IllegalStateException.class)
                    .hasMessageStartingWith("A served trial cannot be reset.");
        }
    }

    @Test
    void directTrialGivesTheReadingsOfTheMessage() {
        try (Trial trial = Trial.direct(ALONE, 1, Controller.ofSpeeds())) {
            trial.run(0.2);
            SensorReadings readings = trial.readings(0);

            assertThat(readings.degrees(Joint.LEFT_KNEE_PITCH))
                    .isEqualTo(readings.message().jointAngles().degreesOr(Joint.LEFT_KNEE_PITCH, 99));
            assertThat(readings.acceleration())
                    .isEqualTo(readings.message().accelerometer().orElseThrow());
            assertThat(readings.gyro()).isEqualTo(readings.message().gyro().orElseThrow());
            assertThat(readings.feet()).isEqualTo(readings.message().footForces());
            assertThat(readings.text().length()).isPositive();
        }
    }

    @Test
    void sceneIsChangedStepByStep() {
        Scene scene = ALONE.withParameters(SoccerParameters.beginner())
                .withLandscape(Landscape.SOCCER)
                .withTeam("Reds");

        assertThat(scene.robots().get(0).team()).isEqualTo("Reds");
        assertThat(TWO.withTeam("Reds").robots()).extracting(RobotStart::team).containsExactly("Reds", "Others");
    }

    @Test
    void mistakeOfAControllerEndsTheTrialAtItsBeginning() {
        Controller broken = new Controller() {
            @Override
            public void awake(SensorReadings readings) {
                throw new IllegalStateException("no brain");
            }

            @Override
            public List<EffectorCommand> respond(SensorReadings readings) {
                return List.of();
            }
        };

        assertThatThrownBy(() -> Trial.direct(ALONE, 1, broken)).hasMessage("no brain");
    }
}
