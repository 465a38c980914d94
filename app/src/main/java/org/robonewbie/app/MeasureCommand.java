package org.robonewbie.app;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.robonewbie.learning.measure.MotionMeasurement;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Tries all shipped motions, or the example agents, many times and prints how well they work. */
@Command(
        name = "measure",
        description =
                "Try all shipped motions or the example agents many times in the simulator and print how well each works.",
        footer = {
            "",
            "Examples:",
            "  robonewbie measure motions                20 trials of each motion",
            "  robonewbie measure motions --seeds 3      a quick look",
            "  robonewbie measure motions --json result.json",
            "  robonewbie measure agents                 20 games of each example agent"
        })
final class MeasureCommand implements Callable<Integer> {

    private static final String MOTIONS = "motions";
    private static final String AGENTS = "agents";

    @Mixin
    final HelpOption help = new HelpOption();

    @Parameters(paramLabel = "motions|agents", description = "What to measure: motions or agents.")
    private String subject = MOTIONS;

    @Option(
            names = "--seeds",
            paramLabel = "N",
            defaultValue = "20",
            description = "Trials of each motion or agent, each disturbed in another way (default: 20).")
    private int seeds;

    @Option(names = "--json", paramLabel = "FILE", description = "Write the results as JSON too.")
    private Optional<Path> json = Optional.empty();

    @Mixin
    final WithoutStudioOption withoutStudio = new WithoutStudioOption();

    @Override
    public Integer call() throws IOException {
        if (!subject.equals(MOTIONS) && !subject.equals(AGENTS)) {
            throw new CalledWronglyException("\"" + subject
                    + "\" cannot be measured; write: robonewbie measure motions, or: robonewbie measure agents");
        }
        if (seeds < 1) {
            throw new CalledWronglyException("--seeds " + seeds + ": give a number of trials of at least 1.");
        }
        if (subject.equals(AGENTS)) {
            new AgentMeasurement(seeds, System.out).run(json);
        } else {
            new MotionMeasurement(seeds, System.out).run(json);
        }
        return ExitCode.OK;
    }
}
