package org.robonewbie.app;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonParser;
import java.io.IOException;
import java.net.URL;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.Enumeration;
import java.util.Optional;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.agent.Agent;
import org.robonewbie.examples.Agent_BetterSoccer;
import org.robonewbie.examples.Agent_SimpleSoccer;
import org.robonewbie.protocol.embedded.EmbeddedSimulator;
import org.robonewbie.protocol.embedded.SimulatorProvider;
import org.robonewbie.protocol.embedded.SimulatorRequest;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.cycle.SteppedSimulator;
import org.robonewbie.simulator.cycle.WorldSettings;

/** An agent whose waiting turns the world, on one thread, lives the same life as one beside a simulator with its own thread. */
class SteppedAgentTest {

    private static final String SERVICE = "META-INF/services/" + SimulatorProvider.class.getName();
    private static final ThreadLocal<String> RECORDING = new ThreadLocal<>();

    @TempDir
    private Path folder;

    @Test
    void simpleSoccerIsTheSameForAMinute() throws IOException {
        compare(Agent_SimpleSoccer::new, "60");
    }

    @Test
    void betterSoccerIsTheSameForHalfAMinute() throws IOException {
        compare(Agent_BetterSoccer::new, "30");
    }

    private void compare(Supplier<Agent> agent, String seconds) throws IOException {
        String threaded = threaded(agent.get(), seconds);

        String stepped = stepped(agent.get(), seconds);

        assertThat(stepped).hasSize(64).isEqualTo(threaded);
    }

    private String threaded(Agent agent, String seconds) throws IOException {
        Path report = folder.resolve("report.json");
        agent.run("--headless", "--fast", "--seed", "1", "--seconds", seconds, "--report", report.toString());
        return JsonParser.parseString(Files.readString(report))
                .getAsJsonObject()
                .get("recordingSha256")
                .getAsString();
    }

    private String stepped(Agent agent, String seconds) throws IOException {
        ClassLoader usual = Thread.currentThread().getContextClassLoader();
        Thread.currentThread().setContextClassLoader(onlySteppedSimulators(usual));
        try {
            agent.run("--headless", "--fast", "--seed", "1", "--seconds", seconds);
        } finally {
            Thread.currentThread().setContextClassLoader(usual);
        }
        return RECORDING.get();
    }

    private ClassLoader onlySteppedSimulators(ClassLoader usual) throws IOException {
        Path provider = Files.writeString(folder.resolve("provider"), SteppedProvider.class.getName());
        URL url = provider.toUri().toURL();
        return new ClassLoader(usual) {
            @Override
            public Enumeration<URL> getResources(String name) throws IOException {
                return name.equals(SERVICE)
                        ? Collections.enumeration(Collections.singleton(url))
                        : super.getResources(name);
            }
        };
    }

    /** Starts simulators on the thread of their agent. */
    public static final class SteppedProvider implements SimulatorProvider {

        @Override
        public EmbeddedSimulator start(SimulatorRequest request) {
            WorldSettings settings =
                    WorldSettings.beginner().withSeed(request.seed().orElseThrow());
            SteppedSimulator simulator = SteppedSimulator.start(settings, Console.silent());
            simulator.endAfter(request.seconds().orElseThrow());
            return new SteppedHome(simulator);
        }
    }

    private record SteppedHome(SteppedSimulator simulator) implements EmbeddedSimulator {

        @Override
        public AgentLink connect() {
            return simulator.connect();
        }

        @Override
        public int agentPort() {
            return 0;
        }

        @Override
        public Optional<String> studioAddress() {
            return Optional.empty();
        }

        @Override
        public void close() {
            RECORDING.set(simulator.report().recordingSha256());
            simulator.close();
        }
    }
}
