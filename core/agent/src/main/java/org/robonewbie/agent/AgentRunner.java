package org.robonewbie.agent;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.concurrent.atomic.AtomicInteger;
import org.robonewbie.agent.cycle.CycleWatch;
import org.robonewbie.agent.cycle.LinkPort;
import org.robonewbie.agent.cycle.MessagePort;
import org.robonewbie.agent.cycle.RobotRuntime;
import org.robonewbie.agent.cycle.Session;
import org.robonewbie.agent.league.LeaguePlayer;
import org.robonewbie.agent.league.LeaguePort;
import org.robonewbie.agent.league.LearnedWalk;
import org.robonewbie.agent.running.ConnectTimeoutHint;
import org.robonewbie.agent.running.CycleOwner;
import org.robonewbie.agent.running.DeadlineMonitor;
import org.robonewbie.agent.running.JoinTurn;
import org.robonewbie.agent.running.LogPrinter;
import org.robonewbie.agent.running.RobotThreads;
import org.robonewbie.agent.running.SimulatorConnection;
import org.robonewbie.agent.running.Watchdog;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.robot.RobotModel;

/** Runs the agents of one program in the same game. */
final class AgentRunner {

    private static final double SECONDS_OF_THE_START = 0.5;

    private final SimulatorConnection simulator;
    private final AtomicInteger exitCode = new AtomicInteger();

    private AgentRunner(SimulatorConnection simulator) {
        this.simulator = simulator;
    }

    /**
     * Plays until the game is over for all agents.
     *
     * @return the program's exit code
     * @throws StartUpException if the game cannot begin
     */
    static int run(List<String> args, List<Agent> agents) {
        check(agents);
        List<Options> options = agents.stream()
                .map(agent -> agent.defaults().overriddenBy(args.toArray(String[]::new)))
                .toList();
        options.forEach(Options::checkWords);
        try (SimulatorConnection simulator =
                open(options.get(0), agents.size(), agents.get(0).getClass().getSimpleName())) {
            return new AgentRunner(simulator).runAll(agents, options);
        }
    }

    static SimulatorConnection open(Options options, int robots, String agent) {
        try {
            SimulatorConnection simulator = SimulatorConnection.open(SimulatorChoice.of(options, robots, agent));
            System.out.println(simulator.description());
            if (options.isTruth()
                    && simulator.isServer()
                    && options.leagueRobot().isEmpty()) {
                System.err.println(
                        "--truth has no effect here: the running simulator decides whether it sends true positions.");
            }
            return simulator;
        } catch (IOException unreachable) {
            throw new StartUpException(String.valueOf(unreachable.getMessage()));
        }
    }

    @SuppressWarnings("try") // closing the hint cancels it
    static Session join(
            RobotRuntime robot,
            SimulatorConnection simulator,
            AgentLink link,
            Options options,
            CycleWatch watch,
            JoinTurn turn)
            throws IOException {
        robot.telemetry().publishTo(simulator.telemetry());
        MessagePort port = port(robot, link, options);
        try (ConnectTimeoutHint notice = ConnectTimeoutHint.of(simulator.place())) {
            new StartDialogue(port, robot, options)
                    .run(
                            () -> {
                                notice.close();
                                turn.answered();
                            },
                            turn::end);
        }
        OptionalDouble life = simulator.isServer() ? options.seconds() : OptionalDouble.empty();
        return new Session(robot, new DeadlineMonitor(port, robot, watch::slowPlace, System::nanoTime), life, watch);
    }

    /** Returns the port through which a robot exchanges messages, in the language of the robot's server. */
    static MessagePort port(RobotRuntime robot, AgentLink link, Options options) {
        return options.leagueRobot()
                .<MessagePort>map(model -> new LeaguePort(
                        link,
                        robot,
                        new LeaguePlayer(model, options.team(), Math.max(1, options.number())),
                        walk(model, options),
                        options.isTruth()))
                .orElseGet(() -> new LinkPort(link, robot.sensors().buffer()));
    }

    private static Optional<LearnedWalk> walk(RobotModel model, Options options) {
        try {
            return LearnedWalk.of(model, options.walk());
        } catch (IllegalArgumentException | UncheckedIOException unusable) {
            throw new StartUpException(
                    "--walk " + options.walk().orElse("") + " cannot be used: " + unusable.getMessage());
        }
    }

    private static void check(List<Agent> agents) {
        if (agents.isEmpty()) {
            throw new StartUpException("runTogether needs at least one agent, such as new MyAgent().");
        }
        if (Set.copyOf(agents).size() < agents.size()) {
            throw new StartUpException("The same agent was passed twice. Create a separate instance for each robot.");
        }
    }

    /**
     * Runs all agents. They connect in the given order, so that a given seed always yields the same game. On a server,
     * each agent joins only after the previous one has reached its starting pose, unless the server starts its clock
     * only when all have joined.
     */
    private int runAll(List<Agent> agents, List<Options> options) {
        if (agents.size() == 1) {
            live(agents.get(0), connect(), options.get(0), new JoinTurn());
            return exitCode.get();
        }
        RobotThreads lives = new RobotThreads();
        boolean oneByOne = simulator.isServer();
        for (int i = 0; i < agents.size(); i++) {
            JoinTurn turn = options.get(i).leagueRobot().isPresent() ? JoinTurn.ofLeague() : new JoinTurn();
            Agent agent = agents.get(i);
            AgentLink link = connect();
            Options own = options.get(i);
            lives.start(() -> live(agent, link, own, turn));
            oneByOne = oneByOne && turn.await();
        }
        lives.await();
        return exitCode.get();
    }

    private AgentLink connect() {
        try {
            return simulator.connect();
        } catch (IOException unreachable) {
            throw new StartUpException(String.valueOf(unreachable.getMessage()));
        }
    }

    private void live(Agent agent, AgentLink link, Options options, JoinTurn turn) {
        try {
            play(agent, link, options, turn);
        } finally {
            turn.end();
        }
    }

    @SuppressWarnings({"try", "ClosingStandardOutputStreams"
    }) // closing the printer prints the log to a stream that stays open
    private void play(Agent agent, AgentLink link, Options options, JoinTurn turn) {
        int code;
        Optional<Runnable> giveUp = options.isHeadless() ? Optional.of(() -> System.exit(1)) : Optional.empty();
        agent.begin(options);
        agent.reportWhatIsMissing();
        link.offerState(new AgentState(agent));
        try (LogPrinter printer = new LogPrinter(agent.runtime().log(), System.out, simulator::close);
                link;
                Watchdog watchdog =
                        Watchdog.start(CycleOwner.FRAMEWORK, agent.runtime().diagnostics(), giveUp, slowness -> {});
                Session session = join(agent.runtime(), simulator, link, options, watchdog, turn)) {
            agent.run(session);
            if (options.isHeadless()) {
                printClosingLine(agent.runtime());
            }
            boolean failed = agent.hasFailed() || session.isBroken();
            code = failed || agent.runtime().diagnostics().isSerious() ? 1 : 0;
        } catch (OutOfMemoryError reported) {
            code = 1;
        } catch (StartUpException refused) {
            System.err.println(refused.getMessage());
            code = 2;
        } catch (IOException lost) {
            System.err.println(joinFailure(options, lost));
            code = 2;
        }
        exitCode.accumulateAndGet(code, Math::max);
    }

    /**
     * Returns a message that explains why a robot could not join: the simulator refused it, or the run was too short.
     */
    static String joinFailure(Options options, IOException lost) {
        double seconds = options.seconds().orElse(Double.POSITIVE_INFINITY);
        return seconds < SECONDS_OF_THE_START
                ? "--seconds " + seconds + " is too short: joining takes about 0.3 s. Use at least 1."
                : "The simulator did not accept the robot: " + lost.getMessage();
    }

    /** Prints a closing line for a headless run that would otherwise print nothing. */
    private static void printClosingLine(RobotRuntime robot) {
        if (robot.log().lines().isEmpty() && robot.diagnostics().reported().isEmpty()) {
            System.out.printf(
                    Locale.ROOT,
                    "The robot played until %.1f s without an error. Use log.info(\"...\") in think() to see what it does.%n",
                    robot.sensors().seconds());
        }
    }
}
