package org.robonewbie.app.command;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import org.robonewbie.programs.ProgramFinder;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Unmatched;

/** {@code robonewbie demo}: runs the simulator, the studio and the example {@code Agent_SimpleSoccer} in one process. */
@Command(
        name = DemoCommand.NAME,
        description = "Watch a robot find the ball and push it, in the browser. This is the default command.",
        customSynopsis = "robonewbie demo [OPTIONS]",
        footer = {
            "",
            "Examples:",
            "  robonewbie demo",
            "  robonewbie demo --headless --fast --seed 1 --seconds 1200 --report run.json"
        })
final class DemoCommand implements Callable<Integer> {

    static final String NAME = "demo";
    private static final String AGENT = "Agent_SimpleSoccer";

    @Mixin
    final HelpOption help = new HelpOption();

    @Unmatched
    private final List<String> agentOptions = new ArrayList<>();

    @Override
    public Integer call() {
        return RunCommand.run(AGENT, new ProgramFinder(List.of()).find(AGENT), agentOptions);
    }
}
