package org.robonewbie.app.command;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Random;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.file.UnreadableFileException;
import org.robonewbie.nao.text.Spelling;
import org.robonewbie.programs.CalledWronglyException;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.cycle.WorldSettings;
import org.robonewbie.simulator.monitor.MonitorSettings;
import org.robonewbie.simulator.script.SoccerParameterFile;
import org.robonewbie.simulator.script.StartScript;
import org.robonewbie.simulator.sensing.CameraSettings;
import org.robonewbie.simulator.server.Simulator;
import org.robonewbie.simulator.server.SimulatorSettings;
import org.robonewbie.simulator.server.WarmUp;
import org.robonewbie.simulator.soccer.SoccerParameters;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;
import picocli.CommandLine.Unmatched;
import picocli.CommandLine.UnmatchedArgumentException;

/** {@code robonewbie simulator}: runs the simulator as a drop-in replacement for rcssserver3d. */
@Command(
        name = SimulatorCommand.NAME,
        description = "Run only the simulator, as a drop-in replacement for rcssserver3d: agents connect by TCP.",
        sortOptions = false,
        footer = {
            "",
            "Examples:",
            "  robonewbie simulator",
            "  robonewbie simulator --sync --seed 7 --set RuleHalfTime=60",
            "  robonewbie simulator --beginner --agent-port 3500",
            "  robonewbie simulator --sync --drop-silent-after 5 --parameters training.properties",
            "  robonewbie simulator --bind 0.0.0.0      accept agents from other computers"
        })
final class SimulatorCommand implements Callable<Integer> {

    static final String NAME = "simulator";
    private static final int DEFAULT_MONITOR_PORT = 3200;
    private static final int LAST_PORT = 65535;

    @Mixin
    final HelpOption help = new HelpOption();

    @Option(
            names = "--agent-port",
            paramLabel = "N",
            description = "Port for agents; 0 for any free one (default: 3100).")
    private Optional<Integer> agentPort = Optional.empty();

    @Option(
            names = {"--monitor-port", "--server-port"},
            paramLabel = "N",
            description = "Port for monitors and trainers; 0 for any free one (default: 3200).")
    private Optional<Integer> monitorPort = Optional.empty();

    @Option(
            names = {"--bind", "--host"},
            paramLabel = "ADDRESS",
            description = "Address to listen on (default: 127.0.0.1, this computer only).")
    private String bindAddress = "127.0.0.1";

    @Option(names = "--sync", description = "Wait for all agents in each cycle instead of running in real time.")
    private boolean synchronous;

    @Option(names = "--fast", description = "Run as fast as possible; implies --sync.")
    private boolean fast;

    @Option(names = "--no-noise", description = "Turn off vision noise.")
    private boolean withoutNoise;

    @Option(
            names = "--ground-truth",
            paramLabel = "WHAT",
            arity = "0..1",
            split = ",",
            fallbackValue = "mypos,myorien,ballpos",
            description = "Send ground truth to robots: mypos (head position), myorien (head direction), ballpos (ball"
                    + " position); all three if none is named.")
    private List<String> groundTruth = new ArrayList<>();

    @Option(
            names = "--drop-silent-after",
            paramLabel = "T",
            description = "With --sync: disconnect an agent that delays a cycle for T real seconds (default: 60); the"
                    + " limit is shorter until its first message.")
    private double silentAgentSeconds = SimulatorSettings.DEFAULT_SILENT_AGENT_SECONDS;

    @Option(
            names = "--seed",
            paramLabel = "S",
            description = "Seed for all random numbers; the same seed gives the same run.")
    private Optional<Long> seed = Optional.empty();

    @Option(names = "--seconds", paramLabel = "T", description = "Stop after T simulated seconds.")
    private Optional<Double> seconds = Optional.empty();

    @Option(
            names = "--wait-for",
            paramLabel = "N",
            description = "Start when N agents are connected. With --sync, the teams then take sides in"
                    + " alphabetical order, regardless of which connects first.")
    private int awaitedAgents;

    @Option(names = "--record", paramLabel = "FILE", description = "Write a recording of the run.")
    private Optional<Path> recording = Optional.empty();

    @Option(names = "--report", paramLabel = "FILE", description = "Write the results as JSON at the end.")
    private Optional<Path> report = Optional.empty();

    @Option(names = "--log", paramLabel = "FILE", description = "Write a log that RoboViz can replay.")
    private Optional<Path> log = Optional.empty();

    @Option(
            names = "--monitor-step",
            paramLabel = "T",
            description = "Simulated seconds between messages to monitors, at least 0.02 (default: 0.04).")
    private double monitorStepSeconds = MonitorSettings.DEFAULT_STEP_SECONDS;

    @Option(
            names = "--no-trainers",
            description =
                    "Ignore the commands of monitors: they can watch, but not move the ball, change the score or stop the simulator.")
    private boolean withoutTrainers;

    @Option(names = "--league", description = "Pitch and rules of the league (default).")
    private boolean league;

    @Option(names = "--beginner", description = "Small pitch and simple rules, as in the demo.")
    private boolean beginner;

    @Mixin
    private final LandscapeOption scene = new LandscapeOption();

    @Option(
            names = "--set",
            paramLabel = "NAME=VALUE",
            description = "Set one of the parameters listed below; can be repeated.")
    private List<String> assignments = new ArrayList<>();

    @Option(
            names = "--parameters",
            paramLabel = "FILE",
            description = "Set parameters from a text file with one NAME=VALUE per line; --set takes precedence.")
    private Optional<Path> parameterFile = Optional.empty();

    @Option(
            names = "--process-name",
            paramLabel = "NAME",
            description = "Name of this process in the process list, for tools that search for it (Linux only).")
    private Optional<String> processName = Optional.empty();

    @Option(
            names = "--script-path",
            paramLabel = "FILE",
            description =
                    "Read parameters and ports from a start script of rcssserver3d and the scripts that it runs; settings"
                            + " that only Ruby can evaluate are reported.")
    private Optional<Path> script = Optional.empty();

    @Unmatched
    private List<String> unknown = new ArrayList<>();

    @Spec
    private @Nullable CommandSpec spec;

    @Override
    public Integer call() throws IOException, InterruptedException {
        Console console = Console.standard();
        ignoreUnknown(console);
        processName.ifPresent(ProcessName::set);
        SimulatorSettings settings = settings(console);
        Simulator simulator = Simulator.start(settings, console);
        Runtime.getRuntime().addShutdownHook(new Thread(simulator::close, "end-of-simulator"));
        console.say("Agents can join on port " + simulator.agentPort() + ", monitors on port "
                + simulator.monitorPort().orElseThrow() + " of " + bindAddress + ". Press Control-C to stop.");
        if (!settings.world().synchronous() && !beginner) {
            startWarmUp(simulator, console);
        }
        simulator.awaitEnd();
        return ExitCode.OK;
    }

    /**
     * Rejects unknown options. With {@code --process-name}, ignores them as rcssserver3d does, because teams' scripts may
     * pass them.
     */
    private void ignoreUnknown(Console console) {
        CommandLine command = Objects.requireNonNull(spec).commandLine();
        if (!unknown.isEmpty() && processName.isEmpty()) {
            throw new UnmatchedArgumentException(command, unknown);
        }
        for (String each : unknown) {
            if (each.startsWith("-")) {
                console.say("Ignoring the unknown option " + each + "."
                        + Spelling.question(each.replaceFirst("=.*", ""), PlainMessages.optionsOf(command)));
            }
        }
    }

    /** Starts the warm-up for real-time matches; it stops when the agents are connected. */
    private void startWarmUp(Simulator simulator, Console console) {
        Thread warmUp = new Thread(
                () -> {
                    try {
                        WarmUp.run(() -> simulator.connectedAgents() < Math.max(1, awaitedAgents));
                    } catch (IOException e) {
                        console.say("The warm-up failed, so the first seconds may be slow: " + e.getMessage());
                    }
                },
                "warm-up");
        warmUp.setDaemon(true);
        warmUp.start();
    }

    /** Converts the options to settings; the command line takes precedence over the script. */
    SimulatorSettings settings(Console console) throws UnreadableFileException {
        if (league && beginner) {
            throw new CalledWronglyException("--league and --beginner cannot be combined. Omit one of them.");
        }
        StartScript start = script.isPresent() ? StartScript.read(script.get(), console) : StartScript.EMPTY;
        boolean isFast = fast || start.isFast();
        CameraSettings camera = CameraSettings.STANDARD
                .withNoise(!withoutNoise)
                .withTruth(isSent("mypos"), isSent("myorien"), isSent("ballpos"));
        WorldSettings world = new WorldSettings(
                parameters(start),
                synchronous || isFast || start.isSynchronous(),
                camera,
                scene.landscape(),
                seed.orElseGet(() -> (long) new Random().nextInt(Integer.MAX_VALUE)));
        int agents = port(agentPort.or(start::agentPort).orElse(SimulatorSettings.DEFAULT_AGENT_PORT));
        int monitors = port(monitorPort.or(start::monitorPort).orElse(DEFAULT_MONITOR_PORT));
        return new SimulatorSettings(
                world,
                new SimulatorSettings.Agents(bindAddress, agents, List.of(), awaitedAgents, silentAgentSeconds()),
                new SimulatorSettings.Monitors(OptionalInt.of(monitors), monitorStep(), !withoutTrainers, log),
                isFast ? SimulationControl.AS_FAST_AS_POSSIBLE : 1,
                seconds.orElse(Double.POSITIVE_INFINITY),
                new SimulatorSettings.Output(recording, report));
    }

    private boolean isSent(String truth) {
        List<String> known = List.of("mypos", "myorien", "ballpos");
        for (String wanted : groundTruth) {
            if (!known.contains(wanted)) {
                throw new CalledWronglyException(
                        "Unknown ground truth \"" + wanted + "\". Choose mypos, myorien or ballpos.");
            }
        }
        return groundTruth.contains(truth);
    }

    private double silentAgentSeconds() {
        if (silentAgentSeconds > 0) {
            return silentAgentSeconds;
        }
        throw new CalledWronglyException("--drop-silent-after " + silentAgentSeconds
                + " is not valid. Use a time above 0, or Infinity to wait without a limit, as rcssserver3d does.");
    }

    private double monitorStep() {
        if (monitorStepSeconds >= Cycle.SECONDS && Double.isFinite(monitorStepSeconds)) {
            return monitorStepSeconds;
        }
        throw new CalledWronglyException("--monitor-step " + monitorStepSeconds
                + " is not valid. The minimum is 0.02, one cycle of the simulation.");
    }

    private static int port(int number) {
        if (number < 0 || number > LAST_PORT) {
            throw new CalledWronglyException(
                    "Port " + number + " does not exist. Ports are 1 to " + LAST_PORT + ", and 0 selects a free one.");
        }
        return number;
    }

    private SoccerParameters parameters(StartScript start) throws UnreadableFileException {
        SoccerParameters parameters = beginner ? SoccerParameters.beginner() : SoccerParameters.league();
        List<String> all = new ArrayList<>(start.parameters());
        if (parameterFile.isPresent()) {
            all.addAll(SoccerParameterFile.read(parameterFile.get()));
        }
        all.addAll(assignments);
        try {
            for (String assignment : all) {
                parameters = parameters.with(assignment);
            }
        } catch (IllegalArgumentException wrong) {
            throw new CalledWronglyException(String.valueOf(wrong.getMessage()));
        }
        return parameters;
    }

    /** Returns a table of all parameters for the help text. */
    static String listOfParameters() {
        return String.format("%-30s %8s %8s%n", "Parameter for --set", "league", "beginner")
                + String.join(System.lineSeparator(), SoccerParameters.describe());
    }
}
