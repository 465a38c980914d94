package org.robonewbie.studio;

import java.io.IOException;
import java.net.URI;
import java.nio.file.Path;
import java.util.Optional;
import org.robonewbie.app.studio.LocalCourseHost;
import org.robonewbie.app.studio.ProcessCompilerService;
import org.robonewbie.exercises.progress.LocalProgress;
import org.robonewbie.exercises.progress.ProgressFile;
import org.robonewbie.exercises.progress.ProgressService;
import org.robonewbie.exercises.progress.SolutionRepository;
import org.robonewbie.exercises.service.CourseService;
import org.robonewbie.protocol.tcp.TelemetryServer;
import org.robonewbie.simulator.cycle.WorldSettings;
import org.robonewbie.simulator.server.Simulator;
import org.robonewbie.simulator.server.SimulatorSettings;

/** A studio with a simulator in which students write programs and solve exercises, as {@code robonewbie studio} starts it. */
final class ProgrammingStudio implements AutoCloseable {

    private final Simulator simulator;
    private final ProcessCompilerService workshop;
    private final CourseService course;
    private final TelemetryServer telemetry;
    private final StudioServer studio;

    /** Starts the studio for the folder of a student's programs and progress. */
    ProgrammingStudio(Path folder) throws IOException {
        simulator = Simulator.start(
                SimulatorSettings.of(WorldSettings.beginner().withSeed(1))
                        .withAgentPort(0)
                        .withAwaitedAgents(1),
                sentence -> {});
        ShownSimulation shown = new ShownSimulation(simulator.control());
        workshop = new ProcessCompilerService(folder);
        Optional<ProgressFile> progress = Optional.of(new ProgressFile(folder.resolve("progress.json")));
        course = new CourseService(
                new ProgressService(new LocalProgress(progress), SolutionRepository.NONE),
                new LocalCourseHost(folder, simulator.control(), shown),
                "");
        StudioFolders folders = new StudioFolders(folder.resolve("motions"), Optional.empty());
        studio = StudioServer.start(shown, 0, AccessToken.random(), folders, course::answer, workshop);
        telemetry = TelemetryServer.open(TelemetryServer.portFor(simulator.agentPort()), studio.telemetry());
    }

    /** {@return an address of the page, which works once} */
    URI address() {
        return studio.oneTimeAddress();
    }

    @Override
    public void close() {
        studio.close();
        workshop.close();
        course.close();
        telemetry.close();
        simulator.close();
    }
}
