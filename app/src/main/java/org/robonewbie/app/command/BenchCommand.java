package org.robonewbie.app.command;

import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

/** All that is measured, in one place: motions, agents, a server under load, speed and fidelity. */
@Command(
        name = "bench",
        description = "Measure motions, agents and the simulator on this computer.",
        synopsisSubcommandLabel = "SUBJECT",
        commandListHeading = "%nSubjects:%n",
        sortOptions = false,
        footer = {
            "",
            "Examples:",
            "  robonewbie bench motions --seeds 3     try each shipped motion three times",
            "  robonewbie bench server --fast         let 22 robots play over TCP",
            "  robonewbie bench speed --robots 1,22   how fast is a step?",
            "  robonewbie bench fidelity              how close is it to the real rcssserver3d?",
            "  robonewbie bench speed --help          more about one subject"
        })
final class BenchCommand {

    @Mixin
    final HelpOption help = new HelpOption();

    private BenchCommand() {}

    /** {@return the command with all its subjects} */
    static CommandLine commandLine() {
        CommandLine bench = new CommandLine(new BenchCommand());
        MeasureCommand.SUBJECTS.forEach(subject -> bench.addSubcommand(subject, MeasureCommand.of(subject)));
        bench.addSubcommand("speed", new BenchmarkCommand());
        bench.addSubcommand("fidelity", new FidelityCommand());
        bench.addSubcommand("record", new RecordReferenceCommand());
        return bench;
    }
}
