package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.app.studio.LocalCourseHost;
import org.robonewbie.app.studio.ProcessCompilerService;
import org.robonewbie.exercises.progress.ProgressService;
import org.robonewbie.exercises.service.CourseService;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.cycle.WorldSettings;
import org.robonewbie.simulator.server.Simulator;
import org.robonewbie.simulator.server.SimulatorSettings;

/**
 * Measures the room Program for {@code docs/performance.md}: the time from opening it to a robot that moves, and from saving a running
 * program to the world that goes on with the changed one. It is not part of the usual tests, since it judges the computer: {@code
 * -Dtest=ProgramRoomMeasurement}.
 */
@InBrowser
class ProgramRoomMeasurement {

    private static final int OPENINGS = 6;
    private static final int HINGE = NaoModel.of(RobotType.TYPE_0).hingeIndex(Joint.LEFT_SHOULDER_PITCH);

    private static final String OPENED = """
            new Promise((done) => {
              let ready = 0;
              let at = 0;
              const look = () => {
                if (!ready && window.studio?.rooms.program?.files?.file !== undefined) {
                  document.querySelector('#program-run').click();
                  ready = performance.now();
                }
                const angle = window.studio?.state.frame?.robots[0]?.degrees[HINGE];
                at ||= angle;
                if (ready && Math.abs(angle - at) > 2) {
                  done([ready, performance.now()].join());
                } else {
                  requestAnimationFrame(look);
                }
              };
              look();
            })
            """.replace("HINGE", "" + HINGE);

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
    private final Chromium browser;
    private String version = "";
    private String cookie = "";

    ProgramRoomMeasurement(Chromium browser) {
        this.browser = browser;
    }

    /** What is done in a studio that has just been started. */
    interface Use {
        void of(URI studio);
    }

    @Test
    void millisecondsFromOpeningToAMovingRobot() throws IOException {
        browser.resize(1366, 768);
        browser.drawSharply();
        double[][] opened = new double[OPENINGS][];
        for (int i = 0; i < OPENINGS; i++) {
            int opening = i;
            inStudio(studio -> {
                ask(studio, "PUT", FILE, PROGRAM.replace("NUMBER", "2"));
                browser.visit(studio + "#program");
                opened[opening] = Arrays.stream(
                                browser.evaluate(OPENED).getAsString().split(","))
                        .mapToDouble(Double::parseDouble)
                        .toArray();
                browser.visit("about:blank");
            });
            version = "";
        }
        print("from opening to the editor", Arrays.stream(opened).mapToDouble(times -> times[0]));
        print(
                "from opening to a moving robot, Run at once",
                Arrays.stream(opened).mapToDouble(times -> times[1]));
    }

    @Test
    void millisecondsFromSavingToTheChangedProgram() throws IOException {
        inStudio(studio -> {
            swap(studio, 0);
            print(
                    "from saving to the changed program",
                    IntStream.rangeClosed(1, SWAPS + PRACTICE)
                            .mapToDouble(number -> swap(studio, number))
                            .skip(PRACTICE));
        });
    }

    private void inStudio(Use use) throws IOException {
        SimulatorSettings pitch = SimulatorSettings.of(WorldSettings.beginner().withSeed(1))
                .withAgentPort(0)
                .withAwaitedAgents(1);
        StudioFolders folders = new StudioFolders(folder.resolve("motions"), Optional.empty());
        try (Simulator simulator = Simulator.start(pitch, Console.silent());
                ProcessCompilerService workshop = new ProcessCompilerService(folder)) {
            ShownSimulation shown = new ShownSimulation(simulator.control());
            try (CourseService course = new CourseService(
                            ProgressService.ofUser(), new LocalCourseHost(folder, simulator.control(), shown), "");
                    StudioServer studio =
                            StudioServer.start(shown, 0, AccessToken.random(), folders, course::answer, workshop)) {
                cookie = StudioCookie.of(studio.oneTimeAddress());
                use.of(studio.address());
            }
        }
    }

    private static void print(String what, DoubleStream milliseconds) {
        double[] sorted = milliseconds.sorted().toArray();
        System.out.printf(
                Locale.ROOT,
                "%s: median %.0f ms (%.0f to %.0f, %d times), load %.1f%n",
                what,
                sorted[sorted.length / 2],
                sorted[0],
                sorted[sorted.length - 1],
                sorted.length,
                ManagementFactory.getOperatingSystemMXBean().getSystemLoadAverage());
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
                .header("Cookie", cookie)
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
