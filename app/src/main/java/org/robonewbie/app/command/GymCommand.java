package org.robonewbie.app.command;

import java.io.IOException;
import java.util.concurrent.Callable;
import org.robonewbie.learning.environment.EnvironmentServer;
import org.robonewbie.programs.CalledWronglyException;
import org.robonewbie.programs.ProgramFinder;
import org.robonewbie.studio.AccessToken;
import org.robonewbie.studio.StudioServer;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** Command that serves environments to the Python package, which starts it automatically. */
@Command(
        name = "gym",
        hidden = true,
        description = {
            "Serve environments to learning programs. The Python package starts this command automatically.",
            "",
            "Prints \"gym PORT\" and serves on 127.0.0.1 until its standard input is closed. docs/gym-protocol.md"
                    + " describes the messages."
        },
        footer = {
            "",
            "In Python, after \"pip install ./research/python\":",
            "  import gymnasium, robonewbie",
            "  env = gymnasium.make(\"RoboNewbie/Walk-v1\")",
            "",
            "Examples:",
            "  robonewbie gym --port 4000"
        })
final class GymCommand implements Callable<Integer> {

    @Mixin
    final HelpOption help = new HelpOption();

    @Mixin
    private final ClassPathOption classPath = new ClassPathOption();

    @Option(
            names = "--port",
            paramLabel = "PORT",
            defaultValue = "0",
            description = "TCP port (default: any free one).")
    private int port;

    @Override
    public Integer call() throws IOException {
        if (port < 0 || port > 65535) {
            throw new CalledWronglyException("--port must be from 0 to 65535, not " + port + ".");
        }
        try (EnvironmentServer server = EnvironmentServer.open(
                port,
                ProgramFinder.loaderOf(classPath.folders()),
                (simulation, any) -> StudioServer.start(simulation, any, AccessToken.ofUser()),
                message -> System.err.println(message))) {
            System.out.println("gym " + server.port());
            System.out.flush();
            while (System.in.read() >= 0) {
                // Input is ignored; end of input means that the training program has exited.
            }
        }
        return ExitCode.OK;
    }
}
