package org.robonewbie.app.command;

import java.io.IOException;
import java.net.URI;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.Callable;
import org.robonewbie.app.studio.LocalStudio;
import org.robonewbie.app.studio.OpenedFile;
import org.robonewbie.programs.CalledWronglyException;
import org.robonewbie.protocol.tcp.TelemetryServer;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.cycle.WorldSettings;
import org.robonewbie.simulator.embedded.Browser;
import org.robonewbie.simulator.embedded.EnterKey;
import org.robonewbie.simulator.embedded.Viewer;
import org.robonewbie.simulator.file.RecordingRepository;
import org.robonewbie.simulator.server.Simulator;
import org.robonewbie.simulator.server.SimulatorSettings;
import org.robonewbie.studio.StudioServer;
import org.robonewbie.studio.monitor.MonitoredSimulation;
import org.robonewbie.studio.monitor.WrongPortException;
import org.robonewbie.studio.roboviz.RoboVizPort;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code robonewbie studio}: opens the studio with its own simulator, a running server or a file. */
@Command(
        name = StudioCommand.NAME,
        description = {
            "Open the studio in the browser. Unless it is watching a server, it starts a simulator that waits for"
                    + " agents on the beginners' pitch.",
            "FILE is a recording (.rec), a server's log (.log, may be gzipped), a motion (.txt), or a"
                    + " program (.java)."
        },
        footer = {
            "",
            "Examples:",
            "  robonewbie studio                     then, in another terminal: robonewbie run Agent_SimpleSoccer",
            "  robonewbie studio --monitor 127.0.0.1:3200     watch a running rcssserver3d or robonewbie simulator",
            "  robonewbie studio --monitor 127.0.0.1:60001    watch a running RCSSServerMJ",
            "  robonewbie studio --roboviz-drawings           also show what teams draw for RoboViz",
            "  robonewbie studio game.rec            replay a recorded run",
            "  robonewbie studio sparkmonitor.log    replay the log of a server",
            "  robonewbie studio motions/wave.txt    edit a motion",
            "  robonewbie studio MyAgent.java        write a program beside the robot"
        })
final class StudioCommand implements Callable<Integer> {

    static final String NAME = "studio";

    @Mixin
    final HelpOption help = new HelpOption();

    @Parameters(
            arity = "0..1",
            paramLabel = "FILE",
            description = "A recording, a server's log, a motion or a program.")
    private Optional<Path> file = Optional.empty();

    @Option(
            names = "--monitor",
            paramLabel = "HOST:PORT",
            description = "Watch the server on this monitor port instead of starting a simulator.")
    private Optional<String> monitor = Optional.empty();

    @Option(
            names = "--agent-port",
            paramLabel = "N",
            description = "Agent port of the built-in simulator (default: 3100).")
    private int agentPort = SimulatorSettings.DEFAULT_AGENT_PORT;

    @Option(
            names = "--port",
            paramLabel = "N",
            description = "Port for the studio's pages (default: 3400, or any free one).")
    private int port;

    @Option(
            names = "--roboviz-drawings",
            paramLabel = "PORT",
            arity = "0..1",
            fallbackValue = "" + RoboVizPort.DEFAULT,
            description =
                    "Show the drawings that teams send to RoboViz, received on this UDP port of 127.0.0.1 (default:"
                            + " ${FALLBACK-VALUE}).")
    private Optional<Integer> drawingPort = Optional.empty();

    @Mixin
    private final LandscapeOption scene = new LandscapeOption();

    @Mixin
    private final LanguageOption language = new LanguageOption();

    @Option(names = "--no-browser", description = "Print the studio's address instead of opening a browser.")
    private boolean withoutBrowser;

    @Override
    public Integer call() throws IOException, InterruptedException {
        OpenedFile opened = OpenedFile.of(file);
        SimulationControl simulation = monitor.isPresent() ? watch(monitor.get()) : start();
        StudioServer view =
                LocalStudio.open(simulation, port, opened, language.language(), List.of(), Optional.empty());
        String place = monitor.isPresent() && file.isEmpty() ? "#field" : opened.place();
        URI address = URI.create(view.oneTimeAddress() + place);
        Runtime.getRuntime().addShutdownHook(new Thread(view::close, "end-of-studio"));
        System.out.println("Studio: " + address + EnterKey.listen(view));
        System.out.println(monitor.map(server -> "Watching the server at " + server + ". Press Control-C to stop.")
                .orElse("Agents can join on port " + agentPort + ". Press Control-C to stop."));
        openTelemetry(view);
        if (drawingPort.isPresent()) {
            RoboVizPort drawings = RoboVizPort.open(drawingPort.get(), view.drawings());
            System.out.println("Showing RoboViz drawings from UDP port " + drawings.number() + ".");
        }
        show(view, place);
        Thread.currentThread().join();
        return ExitCode.OK;
    }

    /** Opens the port to which robots in other processes send telemetry; the studio also works without it. */
    private void openTelemetry(Viewer.View view) {
        try {
            TelemetryServer telemetry = TelemetryServer.open(TelemetryServer.portFor(agentPort), view.telemetry());
            Runtime.getRuntime().addShutdownHook(new Thread(telemetry::close, "end-of-telemetry"));
        } catch (IOException portInUse) {
            System.out.println("Telemetry of robots cannot be shown because its port is in use by another program.");
        }
    }

    private void show(Viewer.View view, String place) {
        if (withoutBrowser) {
            return;
        }
        if (!place.isEmpty()) {
            Browser.open(URI.create(view.oneTimeAddress() + place), Console.standard());
        } else {
            Browser.openUnlessWatched(view, Console.standard());
        }
    }

    private static MonitoredSimulation watch(String server) throws IOException {
        MonitorAddress address = MonitorAddress.of(server);
        MonitoredSimulation match = connect(address);
        Runtime.getRuntime().addShutdownHook(new Thread(match::close, "end-of-watching"));
        if (match.wasSilent()) {
            System.out.println(
                    "Nothing has come from " + server + " yet. If that is an agent port, give the monitor port instead,"
                            + " which is usually 3200 (SimSpark) or 60001 (RCSSServerMJ).");
        }
        return match;
    }

    private static MonitoredSimulation connect(MonitorAddress address) throws IOException {
        try {
            return MonitoredSimulation.connect(
                    address.host(),
                    address.port(),
                    OptionalInt.empty(),
                    () -> RecordingRepository.ofUser().flatMap(repository -> repository.next("")));
        } catch (WrongPortException agentPort) {
            throw new CalledWronglyException(String.valueOf(agentPort.getMessage()));
        }
    }

    private SimulationControl start() throws IOException {
        Optional<Path> recording = file.isPresent()
                ? Optional.empty()
                : RecordingRepository.ofUser().flatMap(shelf -> shelf.next(""));
        Simulator simulator = Simulator.start(
                SimulatorSettings.of(WorldSettings.beginner()
                                .withLandscape(scene.landscape())
                                .withSeed(System.nanoTime() & 0xfffff))
                        .withAgentPort(agentPort)
                        .withAwaitedAgents(1)
                        .withOutput(recording, Optional.empty()),
                Console.standard());
        agentPort = simulator.agentPort();
        Runtime.getRuntime().addShutdownHook(new Thread(simulator::close, "end-of-simulator"));
        return simulator.control();
    }
}
