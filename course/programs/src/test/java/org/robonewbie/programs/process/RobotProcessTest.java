package org.robonewbie.programs.process;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.robonewbie.nao.Joint;
import org.robonewbie.programs.process.Departure.Cause;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;

@Timeout(120)
class RobotProcessTest {

    @TempDir
    private Path folder;

    private final ConcurrentLinkedQueue<String> lines = new ConcurrentLinkedQueue<>();

    @ParameterizedTest
    @EnumSource
    void programMovesItsRobot(Ground ground) throws IOException {
        write(
                "import org.robonewbie.nao.Joint;",
                "nao.setJointSpeed(Joint.LEFT_SHOULDER_PITCH, 60); log.info(\"up\");");

        try (RobotProcess program = start(ground.sandbox());
                RobotProcess.Entrance entrance = program.entrance()) {
            double degrees;
            try (Trial trial = Trial.served(Scene.of(RobotStart.at(-1, 0)), 1, entrance.get())) {
                trial.run(1);
                degrees = trial.robot(0).jointDegrees(Joint.LEFT_SHOULDER_PITCH);
            }

            assertThat(degrees).isGreaterThan(30);
            assertThat(program.isReady()).isTrue();
            assertThat(entrance.departure()).isEmpty();
        }
    }

    @Tag("slow")
    @ParameterizedTest
    @CsvSource({
        "int[] none = {}; none[1] = 0;, FAILED_STEP, ''",
        "System.exit(3);,               EXIT,        3",
        "long[] all = new long[1 << 30];, MEMORY,    512"
    })
    void causeOfADepartureIsReported(String step, Cause cause, String text) throws IOException {
        write("", step);

        try (RobotProcess program = start(Sandbox.none("of this test"));
                RobotProcess.Entrance entrance = program.entrance()) {
            play(entrance);

            Optional<Departure> departure = entrance.departure();

            assertThat(departure).map(Departure::cause).contains(cause);
            assertThat(departure).map(Departure::text).contains(text);
        }
    }

    @Tag("slow")
    @Test
    void robotThatLeavesTheGameStandsUntilTheEndOfTheTrial() throws IOException {
        write("", "leaveGame();");

        try (RobotProcess program = start(Sandbox.none("of this test"));
                RobotProcess.Entrance entrance = program.entrance()) {
            try (Trial trial = Trial.served(Scene.of(RobotStart.at(-1, 0)), 1, entrance.get())) {
                trial.run(1);
            }

            assertThat(entrance.departure()).isEmpty();
        }
    }

    @Tag("slow")
    @Test
    void classThatIsNoAgentIsRefused() throws IOException {
        Files.writeString(folder.resolve("Mover.java"), "public class Mover {}");

        try (RobotProcess program = start(Sandbox.none("of this test"));
                RobotProcess.Entrance entrance = program.entrance()) {
            assertThatThrownBy(() -> Trial.served(Scene.of(RobotStart.at(-1, 0)), 1, entrance.get()))
                    .isInstanceOf(AbsentProgramException.class)
                    .hasMessage("The program ended before it asked for a robot.");

            assertThat(program.exitCode()).isEqualTo(2);
            assertThat(program.isReady()).isFalse();
            assertThat(lines)
                    .anyMatch(line -> line.contains("An exercise needs a class that extends Agent; Mover does not"));
        }
    }

    private static void play(RobotProcess.Entrance entrance) {
        try (Trial trial = Trial.served(Scene.of(RobotStart.at(-1, 0)), 1, entrance.get())) {
            trial.run(0.2);
        } catch (AbsentProgramException left) {
            assertThat(left).hasMessage("The program exited during the trial.");
        }
    }

    private RobotProcess start(Sandbox sandbox) throws IOException {
        RobotProcess.Request request = new RobotProcess.Request("Mover.java", List.of(), folder, true);
        return new RobotProcess(request, sandbox, lines::add);
    }

    private void write(String imports, String step) throws IOException {
        Files.writeString(folder.resolve("Mover.java"), """
                import org.robonewbie.agent.Agent;
                %s
                public class Mover extends Agent {
                    @Override
                    protected void think() {
                        %s
                    }
                }
                """.formatted(imports, step));
    }
}
