package org.robonewbie.agent;

import java.util.List;
import org.robonewbie.agent.running.WantedSimulator;
import org.robonewbie.protocol.embedded.SimulatorRequest;

/**
 * Selects the simulator: options such as {@code --seed} require an embedded one, {@code --host} specifies a server, and
 * without either, a server on this computer is preferred to an embedded simulator.
 */
final class SimulatorChoice {

    private static final String THIS_COMPUTER = "127.0.0.1";
    private static final int DEFAULT_PORT = 3100;
    private static final int LEAGUE_PORT = 60000;
    private static final List<Option> ONLY_OWN_SIMULATOR =
            List.of(Option.SEED, Option.FAST, Option.REPORT, Option.RECORD, Option.WAIT_FOR, Option.SCENE);

    private SimulatorChoice() {}

    /** Rejects options that require an embedded simulator if the same {@link OptionSource} also specifies a server. */
    static void check(Options options) {
        if (options.walk().isPresent() && options.leagueRobot().isEmpty()) {
            throw new StartUpException(Option.WALK.argument() + " needs " + Option.ROBOT.argument()
                    + " T1 or K1: the NAO's walk is chosen by the program.");
        }
        int server = options.strength(Option.HOST);
        for (Option own : ONLY_OWN_SIMULATOR) {
            if (options.leagueRobot().isPresent() && options.strength(own) >= 0) {
                throw new StartUpException(own.argument() + " needs an embedded simulator, which has NAOs only: remove"
                        + " it, or leave out " + Option.ROBOT.argument() + ".");
            }
            if (server >= 0 && options.strength(own) == server) {
                throw new StartUpException(own.argument() + " needs an embedded simulator, but --host "
                        + options.host().orElse("") + " selects a server: remove one of the two options.");
            }
        }
    }

    /** Selects the simulator; an embedded one starts its clock only when all robots have joined. */
    static WantedSimulator of(Options options, int robots, String agent) {
        WantedSimulator.Kind kind = kind(options);
        int serverPort = options.leagueRobot().isPresent() ? LEAGUE_PORT : DEFAULT_PORT;
        boolean anyPort = kind == WantedSimulator.Kind.OWN && serverPort == DEFAULT_PORT;
        int defaultPort = anyPort ? 0 : serverPort;
        int port = options.port().orElse(defaultPort);
        String host = kind == WantedSimulator.Kind.SERVER ? options.host().orElse(THIS_COMPUTER) : THIS_COMPUTER;
        return new WantedSimulator(kind, host, port, request(options, port, robots, agent));
    }

    private static WantedSimulator.Kind kind(Options options) {
        if (options.leagueRobot().isPresent()) {
            return options.host().isPresent() ? WantedSimulator.Kind.SERVER : WantedSimulator.Kind.OWN;
        }
        int own = ONLY_OWN_SIMULATOR.stream().mapToInt(options::strength).max().orElse(-1);
        int server = options.strength(Option.HOST);
        if (own == server) {
            return WantedSimulator.Kind.ANY;
        }
        return own > server ? WantedSimulator.Kind.OWN : WantedSimulator.Kind.SERVER;
    }

    private static SimulatorRequest request(Options options, int port, int robots, String agent) {
        return new SimulatorRequest(
                options.robot(),
                port,
                options.seed(),
                options.isFast(),
                options.seconds(),
                options.isHeadless(),
                !options.isNoBrowser() && !options.isHeadless(),
                options.isTruth(),
                options.scene(),
                options.report(),
                options.record(),
                Math.max(robots, options.waitFor()),
                agent);
    }
}
