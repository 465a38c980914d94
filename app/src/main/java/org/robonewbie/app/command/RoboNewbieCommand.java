package org.robonewbie.app.command;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robonewbie.agent.Options;
import org.robonewbie.learning.environment.EnvironmentSpec;
import org.robonewbie.nao.file.PathEncoding;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Help;
import picocli.CommandLine.IVersionProvider;
import picocli.CommandLine.Model.UsageMessageSpec;
import picocli.CommandLine.TypeConversionException;

/** Root command, which selects and configures the subcommands. */
@Command(
        name = "robonewbie",
        description = "Program a simulated humanoid robot in your first hour.",
        synopsisSubcommandLabel = "COMMAND",
        mixinStandardHelpOptions = true,
        versionProvider = RoboNewbieCommand.Version.class,
        footer = {
            "",
            "Examples:",
            "  robonewbie                            watch a robot play soccer in the browser",
            "  robonewbie run Agent_BasicStructure   run an example",
            "  robonewbie run MyAgent.java           run your own agent",
            "  robonewbie help run                   more about one command",
            "",
            "Exit code: 0 on success, 1 if the command ran and failed, 2 if it was called incorrectly."
        })
public final class RoboNewbieCommand {

    private static final Set<String> OWN_OPTIONS = Set.of("-h", "--help", "-V", "--version");

    private static final Set<String> CHECKS = Set.of("doctor", "help");

    /** The visible commands, grouped as in the help text. */
    private static final List<Group> GROUPS = List.of(
            new Group(
                    "Begin",
                    List.of(
                            DemoCommand.class,
                            RunCommand.class,
                            StudioCommand.class,
                            NewCommand.class,
                            GradeCommand.class,
                            DoctorCommand.class)),
            new Group("Teach", List.of(CompetitionCommand.class, EvaluationCommand.class)),
            new Group(
                    "Explore",
                    List.of(
                            SimulatorCommand.class,
                            RecordCommand.class,
                            ExperimentCommand.class,
                            OptimiseCommand.class,
                            LearnCommand.class,
                            ExportCommand.class)));

    /** Commands that must start fast; the other command classes are not loaded for them. */
    private static final Map<String, Supplier<Object>> AT_ONCE = Map.of(
            SimulatorCommand.NAME, SimulatorCommand::new,
            DemoCommand.NAME, DemoCommand::new,
            RunCommand.NAME, RunCommand::new);

    private RoboNewbieCommand() {}

    /**
     * Runs one command.
     *
     * @param arguments the command and its options; runs the demo if empty
     * @return the exit code: 0 on success, 1 if the command ran and failed, 2 if it was called incorrectly
     */
    public static int run(String... arguments) {
        if (arguments.length == 1 && List.of("-V", "--version").contains(arguments[0])) {
            System.out.println(ProgramVersion.line());
            return CommandLine.ExitCode.OK;
        }
        Optional<String> unreadable = mayWrite(arguments) ? PathEncoding.problem(arguments) : Optional.empty();
        if (unreadable.isPresent()) {
            System.err.println("robonewbie: " + unreadable.get());
            return CommandLine.ExitCode.USAGE;
        }
        String[] complete = withoutHelpOfUnknownCommand(withDefaultCommand(withHelpAsOption(arguments)));
        Supplier<Object> command = AT_ONCE.get(complete[0]);
        return (command == null ? commandLine() : prepared(new CommandLine(new Alone()).addSubcommand(command.get())))
                .execute(complete);
    }

    /** Returns whether a command may write files. Help and {@code doctor} also work if file names cannot be decoded. */
    private static boolean mayWrite(String... arguments) {
        boolean isCheck = arguments.length > 0 && CHECKS.contains(arguments[0]);
        return !isCheck && Stream.of(arguments).noneMatch(OWN_OPTIONS::contains);
    }

    /** {@return all commands with their options} */
    public static CommandLine commandLine() {
        CommandLine commandLine = new CommandLine(new RoboNewbieCommand()).addSubcommand(GymCommand.class);
        GROUPS.forEach(group -> group.commands().forEach(commandLine::addSubcommand));
        return prepared(commandLine);
    }

    private static CommandLine prepared(CommandLine commandLine) {
        commandLine
                .setParameterExceptionHandler(new PlainMessages())
                .setExecutionExceptionHandler(new PlainMessages())
                .registerConverter(Integer.class, text -> number(text, Integer::valueOf, "a whole number"))
                .registerConverter(int.class, text -> number(text, Integer::valueOf, "a whole number"))
                .registerConverter(Long.class, text -> number(text, Long::valueOf, "a whole number"))
                .registerConverter(Double.class, text -> number(text, Double::valueOf, "a number"))
                .setCaseInsensitiveEnumValuesAllowed(true)
                .setUsageHelpAutoWidth(true);
        localizeExamples(commandLine);
        commandLine
                .getCommandSpec()
                .usageMessage()
                .commandListHeading("")
                .sectionMap()
                .put(UsageMessageSpec.SECTION_KEY_COMMAND_LIST, RoboNewbieCommand::groupedCommands);
        subcommand(commandLine, RunCommand.NAME).ifPresent(run -> run.setStopAtPositional(true));
        appendToHelp(commandLine, DemoCommand.NAME, help -> "Options of the agent:\n" + Options.help());
        appendToHelp(commandLine, RunCommand.NAME, help -> "Options of the agent:\n" + Options.help());
        appendToHelp(commandLine, SimulatorCommand.NAME, help -> SimulatorCommand.listOfParameters());
        appendToHelp(
                commandLine,
                CompetitionCommand.NAME,
                help -> "Contests:\n" + help.createTextTable(CompetitionCommand.rules()));
        appendToHelp(
                commandLine,
                LearnCommand.NAME,
                help -> "Tasks:\n" + help.createTextTable(LearnCommand.rules()) + "\nOptions of the tasks:\n"
                        + help.createTextTable(EnvironmentSpec.meaningOfOptions()));
        return commandLine;
    }

    private static String groupedCommands(Help help) {
        return GROUPS.stream()
                .map(group -> {
                    Map<String, Help> commands = new LinkedHashMap<>(help.subcommands());
                    commands.values()
                            .removeIf(command -> !group.commands()
                                    .contains(command.commandSpec().userObject().getClass()));
                    return String.format("%n%s%n", group.title()) + help.commandList(commands);
                })
                .collect(Collectors.joining());
    }

    /** Adapts the examples in each help text so that they can be copied into this terminal. */
    private static void localizeExamples(CommandLine commandLine) {
        ProgramName word = ProgramName.here();
        commandLine
                .getCommandSpec()
                .usageMessage()
                .sectionMap()
                .put(
                        "footer",
                        help -> new HelpExamples(
                                        word, help.commandSpec().usageMessage().width())
                                .text(help.commandSpec().usageMessage().footer()));
        commandLine.getSubcommands().values().forEach(RoboNewbieCommand::localizeExamples);
    }

    /** Appends a list to a command's help. */
    private static void appendToHelp(CommandLine commandLine, String name, Function<Help, String> list) {
        subcommand(commandLine, name).ifPresent(command -> {
            UsageMessageSpec usage = command.getCommandSpec().usageMessage();
            usage.sectionMap().put("list", help -> "\n" + list.apply(help) + "\n");
            usage.sectionKeys(Stream.concat(usage.sectionKeys().stream(), Stream.of("list"))
                    .toList());
        });
    }

    private static Optional<CommandLine> subcommand(CommandLine commandLine, String name) {
        return Optional.ofNullable(commandLine.getSubcommands().get(name));
    }

    /** Removes the help option after an unknown command, so that the command is reported as unknown. */
    private static String[] withoutHelpOfUnknownCommand(String... arguments) {
        boolean isCommand = arguments[0].startsWith("-")
                || AT_ONCE.containsKey(arguments[0])
                || commandLine().getSubcommands().containsKey(arguments[0]);
        return isCommand
                ? arguments
                : Stream.of(arguments)
                        .filter(word -> !OWN_OPTIONS.contains(word))
                        .toArray(String[]::new);
    }

    /** Converts {@code help run} to {@code run --help}. */
    private static String[] withHelpAsOption(String... arguments) {
        return arguments.length > 0 && arguments[0].equals("help")
                ? Stream.concat(Stream.of(arguments).skip(1), Stream.of("--help"))
                        .toArray(String[]::new)
                : arguments;
    }

    /** Prepends the demo command to options without a command, as in {@code robonewbie --seed 3}. */
    private static String[] withDefaultCommand(String... arguments) {
        boolean isDemo = arguments.length == 0 || (arguments[0].startsWith("-") && !OWN_OPTIONS.contains(arguments[0]));
        return isDemo
                ? Stream.concat(Stream.of(DemoCommand.NAME), Stream.of(arguments))
                        .toArray(String[]::new)
                : arguments;
    }

    private static <T> T number(String text, Function<String, T> reading, String expected) {
        try {
            return reading.apply(text);
        } catch (NumberFormatException wrong) {
            throw new TypeConversionException("\"" + text + "\" is not " + expected);
        }
    }

    /** Commands in one section of the help text. */
    private record Group(String title, List<Class<?>> commands) {}

    /** Root command for a single subcommand. */
    @Command(name = "robonewbie")
    private static final class Alone {}

    static final class Version implements IVersionProvider {

        @Override
        public String[] getVersion() {
            return new String[] {ProgramVersion.line()};
        }
    }
}
