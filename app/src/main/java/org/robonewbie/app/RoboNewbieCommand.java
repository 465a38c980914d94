package org.robonewbie.app;

import java.util.Optional;
import picocli.CommandLine.Command;
import picocli.CommandLine.IVersionProvider;

/** The program itself; its commands do the work. */
@Command(
        name = "robonewbie",
        description = "Program a simulated humanoid robot in your first hour.",
        synopsisSubcommandLabel = "COMMAND",
        mixinStandardHelpOptions = true,
        versionProvider = RoboNewbieCommand.Version.class,
        subcommands = {
            DemoCommand.class,
            RunCommand.class,
            SimulatorCommand.class,
            StudioCommand.class,
            FidelityCommand.class,
            RecordCommand.class,
            RecordReferenceCommand.class,
            MeasureCommand.class,
            CompetitionCommand.class,
            OptimiseCommand.class,
            BenchmarkCommand.class,
            GradeCommand.class,
            NewCommand.class,
            EvaluationCommand.class,
            ExperimentCommand.class,
            GymCommand.class,
            DoctorCommand.class
        },
        footer = {
            "",
            "Examples:",
            "  robonewbie                            watch a robot play soccer in the browser",
            "  robonewbie run Agent_BasicStructure   run an example",
            "  robonewbie run MyAgent.java           run your own agent",
            "  robonewbie run --help                 more about one command",
            "",
            "Exit code: 0 all went well, 1 the command ran and failed, 2 it was called wrongly."
        })
final class RoboNewbieCommand {

    /** Tells the version of RoboNewbie and of Java. */
    static final class Version implements IVersionProvider {

        @Override
        public String[] getVersion() {
            String version = Optional.ofNullable(Main.class.getPackage().getImplementationVersion())
                    .orElse("(not packaged)");
            return new String[] {"RoboNewbie " + version + ", Java " + Runtime.version()};
        }
    }
}
