package org.robonewbie.app.command;

import java.io.IOException;
import java.util.concurrent.Callable;
import org.robonewbie.learning.gym.GymOrder;
import org.robonewbie.learning.gym.GymServer;
import org.robonewbie.programs.CalledWronglyException;
import org.robonewbie.programs.ProgramFinder;
import org.robonewbie.studio.AccessToken;
import org.robonewbie.studio.StudioServer;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Serves the tasks of the Python package, which starts it by itself. */
@Command(
        name = "gym",
        hidden = true,
        description = {
            "Serve tasks for learning programs; the Python package starts this by itself.",
            "",
            "Prints \"gym PORT\" and serves on 127.0.0.1 until its standard input ends. Any measure can be a reward: one of the"
                    + " objectives of robonewbie optimise, or a class of your own."
        },
        footer = {
            "",
            "In Python, after \"pip install ./research/python\":",
            "  import gymnasium, robonewbie",
            "  env = gymnasium.make(\"RoboNewbie/Walk-v1\")",
            "",
            "Examples:",
            "  robonewbie gym",
            "  robonewbie gym --port 4000",
            "  robonewbie gym Walk --reward walk-speed"
        })
final class GymCommand implements Callable<Integer> {

    @Mixin
    final HelpOption help = new HelpOption();

    @Parameters(
            arity = "0..1",
            paramLabel = "TASK",
            defaultValue = "Walk",
            description =
                    "Task of programs that name none: Stand, Walk, Follow, Run, GetUp, QuickGetUp, Kick, KickTo, Reach, or a class of yours (Walk).")
    private String task = "Walk";

    @Option(
            names = "--reward",
            paramLabel = "MEASURE",
            defaultValue = "",
            description = "What is rewarded if a program does not choose, such as walk-speed (what the task pays).")
    private String reward = "";

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
            throw new CalledWronglyException("--port " + port + ": give a number from 0 to 65535.");
        }
        try (GymServer server = server()) {
            System.out.println("gym " + server.port());
            System.out.flush();
            while (System.in.read() >= 0) {
                // What is written there has no meaning; its end says that the learning program is gone.
            }
        }
        return ExitCode.OK;
    }

    private GymServer server() throws IOException {
        try {
            return GymServer.open(
                    port,
                    new GymOrder(task, reward),
                    ProgramFinder.loaderOf(classPath.folders()),
                    simulation -> StudioServer.start(simulation, 0, AccessToken.ofUser()),
                    System.err::println);
        } catch (IllegalArgumentException wrong) {
            throw new CalledWronglyException(String.valueOf(wrong.getMessage()));
        }
    }
}
