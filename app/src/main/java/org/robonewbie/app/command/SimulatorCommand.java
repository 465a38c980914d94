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
import org.robonewbie.app.script.StartScript;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.text.Spelling;
import org.robonewbie.programs.CalledWronglyException;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.cycle.WorldSettings;
import org.robonewbie.simulator.monitor.MonitorSettings;
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

/** Runs the simulator alone, in the place of rcssserver3d. */
@Command(
        name = SimulatorCommand.NAME,
        description = "Run only the simulator, in the place of rcssserver3d: agents connect by TCP.",
        sortOptions = false,
        footer = {
            "",
            "Examples:",
            "  robonewbie simulator",
            "  robonewbie simulator --sync --seed 7 --set RuleHalfTime=60",
            "  robonewbie simulator --beginner --agent-port 3500",
            "  robonewbie simulator --sync --drop-silent-after 5 --parameters training.properties",
            "  robonewbie simulator --bind 0.0.0.0      agents on other computers may join"
        })
final class SimulatorCommand implements Callable<Integer> {

    static final String NAME = "simulator";
    private static final int DEFAULT_MONITOR_PORT = 3200;
    private static final int LAST_PORT = 65535;

    @Mixin
    final HelpOption help = new HelpOption();

    @Option(names = "--agent-port", paramLabel = "N", description = "Port for agents, 0 for any free one (3100).")
    private Optional<Integer> agentPort = Optional.empty();

    @Option(
            names = {"--monitor-port", "--server-port"},
            paramLabel = "N",
            description = "Port for monitors and trainers, 0 for any free one (3200).")
    private Optional<Integer> monitorPort = Optional.empty();

    @Option(
            names = {"--bind", "--host"},
            paramLabel = "ADDRESS",
            description = "Address of this computer at which to listen (127.0.0.1: this computer only).")
    private String bindAddress = "127.0.0.1";

    @Option(names = "--sync", description = "Wait for all agents in each cycle instead of running on the clock.")
    private boolean synchronous;

    @Option(names = "--fast", description = "As fast as possible; includes --sync.")
    private boolean fast;

    @Option(names = "--no-noise", description = "Robots see without noise.")
    private boolean withoutNoise;

    @Option(
            names = "--ground-truth",
            paramLabel = "WHAT",
            arity = "0..1",
            split = ",",
            fallbackValue = "mypos,myorien,ballpos",
            description = "Let robots see what is true: mypos (own head), myorien (its direction), ballpos; without"
                    + " WHAT all three.")
    private List<String> groundTruth = new ArrayList<>();

    @Option(
            names = "--drop-silent-after",
            paramLabel = "T",
            description = "With --sync: drop an agent that keeps the world waiting for T real seconds (60); a"
                    + " newcomer sooner.")
    private double silentAgentSeconds = SimulatorSettings.DEFAULT_SILENT_AGENT_SECONDS;

    @Option(names = "--seed", paramLabel = "S", description = "Start of all random numbers: same seed, same run.")
    private Optional<Long> seed = Optional.empty();

    @Option(names = "--seconds", paramLabel = "T", description = "End after T simulated seconds.")
    private Optional<Double> seconds = Optional.empty();

    @Option(
            names = "--wait-for",
            paramLabel = "N",
            description = "Begin when N agents are connected. With --sync their order does not matter then: the"
                    + " teams take the sides in the order of their names.")
    private int awaitedAgents;

    @Option(names = "--record", paramLabel = "FILE", description = "Write a recording of the run.")
    private Optional<Path> recording = Optional.empty();

    @Option(names = "--report", paramLabel = "FILE", description = "Write the true results as JSON at the end.")
    private Optional<Path> report = Optional.empty();

    @Option(names = "--log", paramLabel = "FILE", description = "Write a log that RoboViz can replay.")
    private Optional<Path> log = Optional.empty();

    @Option(
            names = "--monitor-step",
            paramLabel = "T",
            description = "Simulated seconds between two messages to monitors, at least 0.02 (0.04).")
    private double monitorStepSeconds = MonitorSettings.DEFAULT_STEP_SECONDS;

    @Option(
            names = "--no-trainers",
            description = "Let monitors watch only: nobody may move the ball, score or end it.")
    private boolean withoutTrainers;

    @Option(names = "--league", description = "Pitch and rules of the league. This is the usual profile.")
    private boolean league;

    @Option(names = "--beginner", description = "Small pitch and simple rules, as in the demo.")
    private boolean beginner;

    @Mixin
    private final LandscapeOption scene = new LandscapeOption();

    @Option(
            names = "--set",
            paramLabel = "NAME=VALUE",
            description = "Change one of the parameters that are listed below; can be repeated.")
    private List<String> assignments = new ArrayList<>();

    @Option(
            names = "--parameters",
            paramLabel = "FILE",
            description = "Change parameters as a text file says, one NAME=VALUE per line; --set is stronger.")
    private Optional<Path> parameterFile = Optional.empty();

    @Option(
            names = "--process-name",
            paramLabel = "NAME",
            description = "Name under which the system lists this program, for tools that look for it (Linux only).")
    private Optional<String> processName = Optional.empty();

    @Option(
            names = "--script-path",
            paramLabel = "FILE",
            description =
                    "Take parameters and ports from a start script of rcssserver3d and those that it runs; settings"
                            + " that only Ruby can calculate are named.")
    private Optional<Path> script = Optional.empty();

    @Unmatched
    private List<String> unknown = new ArrayList<>();

    @Spec
    private @Nullable CommandSpec spec;

    @Override
    public Integer call() throws IOException, InterruptedException {
        Console console = Console.standard();
        leaveOutUnknown(console);
        processName.ifPresent(ProcessName::set);
        SimulatorSettings settings = settings(console);
        Simulator simulator = Simulator.start(settings, console);
        Runtime.getRuntime().addShutdownHook(new Thread(simulator::close, "end-of-simulator"));
        console.say("Agents can join at port " + simulator.agentPort() + ", monitors at port "
                + simulator.monitorPort().orElseThrow() + " of " + bindAddress + ". Control-C ends it.");
        if (!settings.world().synchronous() && !beginner) {
            startWarmUp(simulator, console);
        }
        simulator.awaitEnd();
        return ExitCode.OK;
    }

    /** In the place of the original, options are left out as there, since scripts of tools and teams give some; else refused. */
    private void leaveOutUnknown(Console console) {
        CommandLine command = Objects.requireNonNull(spec).commandLine();
        if (!unknown.isEmpty() && processName.isEmpty()) {
            throw new UnmatchedArgumentException(command, unknown);
        }
        for (String each : unknown) {
            if (each.startsWith("-")) {
                console.say("The option " + each + " is left out, since it does not exist here."
                        + Spelling.question(each.replaceFirst("=.*", ""), PlainMessages.optionsOf(command)));
            }
        }
    }

    /** Prepares for many robots on the clock; as soon as the world goes on with agents, all power of the computer is for it. */
    private void startWarmUp(Simulator simulator, Console console) {
        Thread warmUp = new Thread(
                () -> {
                    try {
                        WarmUp.run(() -> simulator.connectedAgents() < Math.max(1, awaitedAgents));
                    } catch (IOException e) {
                        console.say("The warm-up has failed, so the first seconds may be slow: " + e.getMessage());
                    }
                },
                "warm-up");
        warmUp.setDaemon(true);
        warmUp.start();
    }

    /** Translates the options; what is given on the command line is stronger than the script. */
    SimulatorSettings settings(Console console) {
        if (league && beginner) {
            throw new CalledWronglyException("--league and --beginner exclude each other. Leave one of them out.");
        }
        StartScript start = script.map(file -> StartScript.read(file, console)).orElse(StartScript.EMPTY);
        boolean isFast = fast || start.isFast();
        CameraSettings camera = CameraSettings.STANDARD
                .withNoise(!withoutNoise)
                .withTruth(isTold("mypos"), isTold("myorien"), isTold("ballpos"));
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

    private boolean isTold(String truth) {
        List<String> known = List.of("mypos", "myorien", "ballpos");
        for (String wanted : groundTruth) {
            if (!known.contains(wanted)) {
                throw new CalledWronglyException(
                        "No ground truth \"" + wanted + "\" exists. Choose of mypos, myorien and ballpos.");
            }
        }
        return groundTruth.contains(truth);
    }

    private double silentAgentSeconds() {
        if (silentAgentSeconds > 0) {
            return silentAgentSeconds;
        }
        throw new CalledWronglyException("An agent cannot be dropped after " + silentAgentSeconds
                + " s. Give a time above 0, or Infinity to wait for ever as rcssserver3d does.");
    }

    private double monitorStep() {
        if (monitorStepSeconds >= Cycle.SECONDS && Double.isFinite(monitorStepSeconds)) {
            return monitorStepSeconds;
        }
        throw new CalledWronglyException("A monitor step of " + monitorStepSeconds
                + " s is not possible. It is at least 0.02, one cycle of the simulation.");
    }

    private static int port(int number) {
        if (number < 0 || number > LAST_PORT) {
            throw new CalledWronglyException(
                    "Port " + number + " does not exist. Ports are 1 to " + LAST_PORT + ", and 0 takes any free one.");
        }
        return number;
    }

    private SoccerParameters parameters(StartScript start) {
        SoccerParameters parameters = beginner ? SoccerParameters.beginner() : SoccerParameters.league();
        List<String> all = new ArrayList<>(start.parameters());
        all.addAll(parameterFile.map(ParameterFile::read).orElse(List.of()));
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

    /** All parameters with their values, for the help. */
    static String listOfParameters() {
        return String.format("%-30s %8s %8s%n", "Parameter for --set", "league", "beginner")
                + String.join(System.lineSeparator(), SoccerParameters.describe());
    }
}
