package org.robonewbie.trial.watch;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.FutureTask;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.SimulationObserver;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.recording.RecordingTarget;
import org.robonewbie.trial.Controller;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;

class WatchedTrialTest {

    private final WatchedTrial watched = new WatchedTrial();
    private final List<WorldSnapshot> seen = new ArrayList<>();

    WatchedTrialTest() {
        watched.order(new Order.SetSpeed(SimulationControl.AS_FAST_AS_POSSIBLE));
    }

    private Trial trial() {
        Scene scene = Scene.of(RobotStart.at(0, 0));
        return Trial.observed(scene, 1, watched, RecordingTarget.NONE, start -> Controller.ofSpeeds());
    }

    @Test
    void observersSeeEachCycleAndTheLastOneStopped() {
        SimulationObserver observer = seen::add;
        watched.addObserver(observer);

        try (Trial trial = trial()) {
            int entry = seen.size();
            trial.run(0.1);
            assertThat(seen).hasSize(entry + 5);
            watched.leave();
        }

        assertThat(seen.get(seen.size() - 1).paused()).isTrue();
        watched.removeObserver(observer);
        watched.addObserver(late -> seen.clear());
        assertThat(seen).isEmpty();
        assertThat(watched.field()).isEqualTo(SoccerField.BEGINNER);
        assertThat(watched.trial()).isEmpty();
    }

    @Test
    void robotIsFirstSeenAtItsStart() {
        watched.addObserver(seen::add);

        trial().close();

        WorldSnapshot first = seen.get(0);
        assertThat(first.teamLeft()).isEqualTo(RobotStart.TEAM);
        assertThat(first.robots().get(0).body().position().z()).isLessThan(0.5);
    }

    @Test
    void speedOfAStoppedTrialIsSeenToChange() {
        try (Trial trial = trial()) {
            trial.step();
        }
        watched.leave();
        watched.addObserver(seen::add);

        watched.order(new Order.SetSpeed(1));

        assertThat(seen).extracting(WorldSnapshot::speed).containsExactly(SimulationControl.AS_FAST_AS_POSSIBLE, 1.0);
        assertThat(seen).allMatch(WorldSnapshot::paused);
    }

    @Test
    void pausedTrialWaitsForStepsAndForResume() throws Exception {
        CountDownLatch held = new CountDownLatch(1);
        try (Trial trial = trial()) {
            watched.order(new Order.Pause());
            watched.order(new Order.Step(2));
            watched.addObserver(snapshot -> {
                if (snapshot.paused()) {
                    held.countDown();
                }
            });
            FutureTask<Double> run = new FutureTask<>(() -> {
                trial.run(0.1);
                return trial.seconds();
            });
            Thread thread = new Thread(run);
            thread.start();
            held.await();
            assertThat(run.isDone()).isFalse();

            watched.order(new Order.Resume());

            assertThat(run.get()).isGreaterThanOrEqualTo(0.1);
        }
    }

    @Test
    void interruptedTrialIsNoLongerHeld() throws Exception {
        try (Trial trial = trial()) {
            watched.order(new Order.Pause());
            FutureTask<Boolean> run = new FutureTask<>(() -> {
                Thread.currentThread().interrupt();
                trial.step();
                return Thread.interrupted();
            });
            Thread thread = new Thread(run);
            thread.start();

            assertThat(run.get()).isTrue();
        }
    }
}
