package org.robonewbie.exercises;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.util.Optional;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.agent.Agent;
import org.robonewbie.programs.process.GuestDoor;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.tcp.FrameInput;
import org.robonewbie.protocol.tcp.FrameOutput;
import org.robonewbie.trial.Controller;
import org.robonewbie.trial.TrialListener;

class GuestDoorTest {

    @ParameterizedTest
    @ValueSource(strings = {"raise-arms", "stop-at-30", "arm-by-side", "kick", "get-up", "passing", "where-am-i"})
    void agentThatComesThroughTheDoorPassesAsOneOfThisProcess(String name) throws IOException {
        Exercise exercise = Exercises.find(name).orElseThrow();

        try (GuestDoor door = GuestDoor.open(0)) {
            Score score = Performance.of(
                    exercise, 4, () -> guest(door, Solutions.of(exercise)), Optional.empty(), TrialListener.NONE);

            assertThat(score.passed()).as(score.toString()).isTrue();
        }
    }

    @Test
    void programThatNeverComesFailsTheTrial() throws IOException {
        try (GuestDoor door = GuestDoor.open(0)) {
            Score score =
                    Performance.of(exercise(), 1, () -> door.await(() -> false), Optional.empty(), TrialListener.NONE);

            assertThat(score.passed()).isFalse();
            assertThat(score.finding()).isEqualTo("The program ended before it asked for a robot.");
        }
    }

    @Test
    void programThatGoesAwayFailsTheTrial() throws IOException {
        try (GuestDoor door = GuestDoor.open(0)) {
            Score score = Performance.of(
                    exercise(),
                    1,
                    () -> {
                        begin(door, 20);
                        return door.await(() -> true);
                    },
                    Optional.empty(),
                    TrialListener.NONE);

            assertThat(score.finding()).startsWith("The program has");
        }
    }

    private static Exercise exercise() {
        return Exercises.find("raise-arms").orElseThrow();
    }

    private static Controller guest(GuestDoor door, Supplier<? extends Agent> agents) {
        String port = Integer.toString(door.port());
        daemon(() -> agents.get().run("--port", port, "--team", "Students"));
        return door.await(() -> true);
    }

    /** An agent that answers some messages without moving, and goes. */
    private static void begin(GuestDoor door, int answers) {
        daemon(() -> {
            try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), door.port())) {
                FrameOutput output = new FrameOutput(socket.getOutputStream());
                FrameInput input = new FrameInput(socket.getInputStream(), 1 << 20);
                for (int i = 0; i < answers; i++) {
                    output.write(text("(syn)"));
                    input.read(new MessageBuffer());
                }
            } catch (IOException end) {
                // the door has been closed
            }
        });
    }

    private static MessageBuffer text(String words) {
        MessageBuffer message = new MessageBuffer();
        message.append(words);
        return message;
    }

    private static void daemon(Runnable work) {
        Thread thread = new Thread(work, "guest");
        thread.setDaemon(true);
        thread.start();
    }
}
