package org.robonewbie.workshop.load;

import java.io.IOException;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.lang.reflect.Constructor;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.stream.IntStream;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.AgentDriver;
import org.robonewbie.agent.Options;
import org.robonewbie.agent.running.RobotThreads;
import org.robonewbie.nao.Cycle;
import org.robonewbie.programs.ExampleCatalogue;
import org.robonewbie.protocol.tcp.TcpAgentLink;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.cycle.WorldSettings;
import org.robonewbie.simulator.server.Simulator;
import org.robonewbie.simulator.server.SimulatorSettings;
import org.robonewbie.simulator.server.WarmUp;

/**
 * Plays each example over TCP on a simulator that runs in real time, and measures the processor time of its cycles and the number of missed
 * cycles.
 */
public final class ExampleLoad {

    private static final int PLAYERS_OF_A_TEAM = 3;
    private static final double SILENT_AGENT_SECONDS = 60;

    private final double warmUpSeconds;
    private final double seconds;

    /**
     * Creates a measurement.
     *
     * @param warmUpSeconds simulated seconds at the start of each run that are not measured
     * @param seconds measured simulated seconds of each run
     */
    public ExampleLoad(double warmUpSeconds, double seconds) {
        this.warmUpSeconds = warmUpSeconds;
        this.seconds = seconds;
    }

    /**
     * Measures examples one after the other and then prints a Markdown table.
     *
     * @param part substring of the names of the examples to measure; empty for all
     * @param out destination of the table
     * @throws IOException if a simulator cannot be started
     * @throws IllegalArgumentException if no name contains the substring
     */
    public void run(String part, PrintStream out) throws IOException {
        Map<String, Class<? extends Agent>> chosen = examples();
        chosen.keySet().removeIf(name -> !name.contains(part));
        if (chosen.isEmpty()) {
            throw new IllegalArgumentException("No example's name contains \"" + part + "\".");
        }
        WarmUp.run(() -> true);
        List<ExampleLoadResult> results = new ArrayList<>();
        for (Map.Entry<String, Class<? extends Agent>> example : chosen.entrySet()) {
            out.println(example.getKey() + " plays");
            results.add(measure(example.getKey(), agents(example.getValue())));
        }
        out.println();
        out.print(ExampleLoadResult.TITLE);
        results.forEach(result -> out.println(result.toRow()));
    }

    /** {@return the examples whose cycle is run by the framework, by name; {@code Agent_Wave} runs its own cycle} */
    public static Map<String, Class<? extends Agent>> examples() {
        Map<String, Class<? extends Agent>> examples = new LinkedHashMap<>();
        ExampleCatalogue.classNames().forEach((name, className) -> {
            Class<?> type = load(className);
            if (Agent.class.isAssignableFrom(type)) {
                examples.put(name, type.asSubclass(Agent.class));
            }
        });
        return examples;
    }

    private static Class<?> load(String className) {
        try {
            return Class.forName(className);
        } catch (ClassNotFoundException missing) {
            throw new IllegalStateException(missing);
        }
    }

    private ExampleLoadResult measure(String name, List<Agent> agents) throws IOException {
        try (Simulator simulator = Simulator.start(settings(agents.size()), Console.silent())) {
            RobotThreads lives = new RobotThreads();
            List<ThinkTimes> times = new ArrayList<>();
            for (Agent agent : agents) {
                ThinkTimes link = new ThinkTimes(
                        TcpAgentLink.connect(SimulatorSettings.LOCALHOST, simulator.agentPort()),
                        cycles(warmUpSeconds),
                        cycles(seconds));
                times.add(link);
                lives.start(() -> play(agent, link));
            }
            lives.await();
            return ExampleLoadResult.of(name, times);
        }
    }

    private static int cycles(double seconds) {
        return (int) Math.round(seconds / Cycle.SECONDS);
    }

    private static SimulatorSettings settings(int robots) {
        return SimulatorSettings.of(WorldSettings.beginner().withSynchronous(false))
                .withAgents(new SimulatorSettings.Agents(
                        SimulatorSettings.LOCALHOST, 0, List.of(), robots, SILENT_AGENT_SECONDS))
                .withSpeed(1);
    }

    private void play(Agent agent, ThinkTimes link) {
        AgentDriver driver = new AgentDriver(agent);
        Options options = driver.defaultOptions().overriddenBy("--seconds", String.valueOf(warmUpSeconds + seconds));
        try (link) {
            driver.play(link, options);
        } catch (IOException lost) {
            throw new UncheckedIOException(lost);
        }
    }

    /**
     * Creates the robots of an example.
     *
     * @param type its class
     * @return a team if its constructor takes a player number, otherwise one robot
     */
    public static List<Agent> agents(Class<? extends Agent> type) {
        boolean team = Arrays.stream(type.getConstructors()).anyMatch(each -> each.getParameterCount() == 1);
        return team
                ? IntStream.rangeClosed(1, PLAYERS_OF_A_TEAM)
                        .mapToObj(number -> create(type, OptionalInt.of(number)))
                        .toList()
                : List.of(create(type, OptionalInt.empty()));
    }

    private static Agent create(Class<? extends Agent> type, OptionalInt number) {
        try {
            Constructor<? extends Agent> constructor =
                    number.isPresent() ? type.getConstructor(int.class) : type.getConstructor();
            return number.isPresent() ? constructor.newInstance(number.getAsInt()) : constructor.newInstance();
        } catch (ReflectiveOperationException impossible) {
            throw new IllegalStateException(type + " cannot be created", impossible);
        }
    }
}
