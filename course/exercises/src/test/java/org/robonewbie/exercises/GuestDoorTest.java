package org.robonewbie.exercises;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.Optional;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.agent.Agent;
import org.robonewbie.programs.process.GuestDoor;
import org.robonewbie.trial.Controller;
import org.robonewbie.trial.TrialListener;

class GuestDoorTest {

    @ParameterizedTest
    @ValueSource(strings = {"raise-arms", "stop-at-30", "arm-by-side", "kick", "get-up", "passing", "where-am-i"})
    void agentThatComesThroughTheDoorPassesAsOneOfThisProcess(String name) throws IOException {
        Exercise exercise = Exercises.find(name).orElseThrow();

        try (GuestDoor door = GuestDoor.open(0)) {
            Score score = play(exercise, () -> guest(door, Solutions.of(exercise)));

            assertThat(score.passed()).as(score.toString()).isTrue();
        }
    }

    @Test
    void absenceOfTheProgramFailsTheTrial() throws IOException {
        Exercise exercise = Exercises.find("raise-arms").orElseThrow();

        try (GuestDoor door = GuestDoor.open(0)) {
            Score score = play(exercise, () -> door.await(() -> false));

            assertThat(score.passed()).isFalse();
            assertThat(score.finding()).isEqualTo("The program ended before it asked for a robot.");
        }
    }

    private static Score play(Exercise exercise, Supplier<Controller> controllers) {
        return Performance.of(exercise, 4, controllers, Optional.empty(), TrialListener.NONE);
    }

    private static Controller guest(GuestDoor door, Supplier<? extends Agent> agents) {
        String port = Integer.toString(door.port());
        Thread thread = new Thread(() -> agents.get().run("--port", port, "--team", "Students"), "guest");
        thread.setDaemon(true);
        thread.start();
        return door.await(() -> true);
    }
}
