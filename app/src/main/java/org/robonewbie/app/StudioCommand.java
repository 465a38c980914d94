package org.robonewbie.app;

import java.io.IOException;
import java.net.URI;
import java.nio.file.Path;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import java.util.ServiceLoader;
import java.util.concurrent.Callable;
import org.robonewbie.protocol.embedded.EmbeddedSimulator;
import org.robonewbie.protocol.embedded.SimulatorProvider;
import org.robonewbie.protocol.embedded.SimulatorRequest;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Opens the studio with a simulator behind it, for agents that are started elsewhere. */
@Command(
        name = "studio",
        description = {
            "Start a simulator with the studio in the browser and wait for agents, on the beginners' pitch.",
            "It cannot watch a simulator of another process yet, nor open recordings and motion files."
        },
        footer = {
            "",
            "Examples:",
            "  robonewbie studio                     then, in another window: robonewbie run Agent_SimpleSoccer",
            "  robonewbie studio --no-browser"
        })
final class StudioCommand implements Callable<Integer> {

    @Mixin
    final HelpOption help = new HelpOption();

    @Parameters(arity = "0..1", paramLabel = "FILE", description = "A recording or motion file (not yet possible).")
    private Optional<Path> file = Optional.empty();

    @Option(names = "--agent-port", paramLabel = "N", description = "Port for agents (3100).")
    private int agentPort = 3100;

    @Option(names = "--no-browser", description = "Print the studio's address and open no browser.")
    private boolean withoutBrowser;

    @Override
    public Integer call() throws IOException, InterruptedException {
        if (file.isPresent()) {
            throw new CalledWronglyException(
                    "The studio cannot open " + file.get()
                            + " yet: recordings and motion files are still to come. Without a file it shows a running simulation.");
        }
        EmbeddedSimulator simulator = start();
        Runtime.getRuntime().addShutdownHook(new Thread(simulator::close, "end-of-studio"));
        System.out.println(
                "Studio: " + simulator.studioAddress().map(URI::toString).orElse("(none)"));
        System.out.println("Agents can join at port " + simulator.agentPort() + ". Control-C ends it.");
        Thread.currentThread().join();
        return ExitCode.OK;
    }

    private EmbeddedSimulator start() throws IOException {
        SimulatorProvider provider = ServiceLoader.load(SimulatorProvider.class)
                .findFirst()
                .orElseThrow(() -> new IllegalStateException("This program has been packed without a simulator."));
        return provider.start(new SimulatorRequest(
                agentPort,
                OptionalLong.empty(),
                false,
                OptionalDouble.empty(),
                false,
                !withoutBrowser,
                false,
                Optional.empty(),
                Optional.empty(),
                1));
    }
}
