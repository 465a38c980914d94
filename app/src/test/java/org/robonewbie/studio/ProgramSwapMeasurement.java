package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.app.course.Coach;
import org.robonewbie.app.studio.CourseDesk;
import org.robonewbie.app.studio.ProgramWorkshop;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.server.Simulator;
import org.robonewbie.simulator.server.SimulatorSettings;

/**
 * Measures the time from saving a running program in the room for programs to the world that goes on with the changed one, for
 * {@code docs/program-room.md}. It is not part of the usual tests, since it judges the computer: {@code
 * -Dtest=ProgramSwapMeasurement}.
 */
class ProgramSwapMeasurement {

    private static final int SWAPS = 15;
    private static final int PRACTICE = 3;
    private static final String FILE = "programs/own/Swapped.java";
    private static final String PROGRAM = """
            import org.robonewbie.agent.Agent;
            import org.robonewbie.nao.Joint;

            public class Swapped extends Agent {
                public static void main(String[] args) {
                    new Swapped().run(args);
                }

                @Override
                protected void think() {
                    nao.setJointSpeed(Joint.LEFT_SHOULDER_PITCH, NUMBER);
                }
            }
            """;

    @TempDir
    private Path folder;

    private final HttpClient page = HttpClient.newHttpClient();
    private String version = "";

    @Test
    void millisecondsFromSavingToTheChangedProgram() throws Exception {
        SimulatorSettings pitch = SimulatorSettings.beginner()
                .agentPort(0)
                .synchronous(true)
                .awaitedAgents(1)
                .seed(1)
                .build();
        StudioFolders folders = new StudioFolders(folder.resolve("motions"), Optional.empty());
        try (Simulator simulator = Simulator.start(pitch, Console.silent());
                ProgramWorkshop workshop = new ProgramWorkshop(folder)) {
            ShownSimulation shown = new ShownSimulation(simulator.control());
            try (CourseDesk course = new CourseDesk(folder, simulator.control(), shown, Coach.ofUser());
                    StudioServer studio =
                            StudioServer.start(shown, 0, AccessToken.random(), folders, course, workshop)) {
                swap(studio.address(), 0);
                double[] milliseconds = IntStream.rangeClosed(1, SWAPS + PRACTICE)
                        .mapToDouble(number -> swap(studio.address(), number))
                        .skip(PRACTICE)
                        .sorted()
                        .toArray();
                System.out.printf(
                        Locale.ROOT,
                        "from saving to the changed program: %.0f ms (%.0f to %.0f, median of %d), load %.1f%n",
                        milliseconds[SWAPS / 2],
                        milliseconds[0],
                        milliseconds[SWAPS - 1],
                        SWAPS,
                        ManagementFactory.getOperatingSystemMXBean().getSystemLoadAverage());
            }
        }
    }

    private double swap(URI studio, int number) {
        long start = System.nanoTime();
        HttpResponse<String> saved = ask(studio, "PUT", FILE, PROGRAM.replace("NUMBER", Integer.toString(number)));
        version = saved.headers().firstValue("Version").orElseThrow();
        HttpResponse<String> run = ask(studio, "POST", "programs/run/Swapped.java?world=keep", "");
        assertThat(run.body()).contains("RUNNING");
        return (System.nanoTime() - start) / 1e6;
    }

    private HttpResponse<String> ask(URI studio, String method, String path, String body) {
        HttpRequest request = HttpRequest.newBuilder(studio.resolve("/api/" + path))
                .header("Studio-Token", studio.getQuery().replace("token=", ""))
                .header("Origin", "http://" + studio.getAuthority())
                .header("Known-Version", version)
                .method(method, HttpRequest.BodyPublishers.ofString(body))
                .build();
        try {
            return page.send(request, HttpResponse.BodyHandlers.ofString());
        } catch (IOException | InterruptedException failed) {
            throw new AssertionError(failed);
        }
    }
}
