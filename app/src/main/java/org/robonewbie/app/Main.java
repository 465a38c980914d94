package org.robonewbie.app;

import java.util.Objects;
import java.util.Set;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.robonewbie.agent.Options;
import picocli.CommandLine;
import picocli.CommandLine.Model.UsageMessageSpec;
import picocli.CommandLine.TypeConversionException;

/**
 * Starts RoboNewbie from the command line. The exit code is 0 when all went well, 1 when a command ran and failed, 2 when
 * it was called wrongly.
 */
public final class Main {

    private static final Set<String> OWN_OPTIONS = Set.of("-h", "--help", "-V", "--version");

    private Main() {}

    /**
     * Runs one command and ends the process.
     *
     * @param arguments the command and its options; none runs the demo
     */
    public static void main(String[] arguments) {
        QuietLogging.install();
        System.exit(run(arguments));
    }

    /** Runs one command and tells the exit code. */
    static int run(String... arguments) {
        return commandLine().execute(withDefaultCommand(arguments));
    }

    static CommandLine commandLine() {
        CommandLine commandLine = new CommandLine(new RoboNewbieCommand())
                .setParameterExceptionHandler(new PlainMessages())
                .setExecutionExceptionHandler(new PlainMessages())
                .registerConverter(Integer.class, text -> number(text, Integer::valueOf, "a whole number"))
                .registerConverter(int.class, text -> number(text, Integer::valueOf, "a whole number"))
                .registerConverter(Long.class, text -> number(text, Long::valueOf, "a whole number"))
                .registerConverter(Double.class, text -> number(text, Double::valueOf, "a number"))
                .setCaseInsensitiveEnumValuesAllowed(true)
                .setUsageHelpAutoWidth(true);
        subcommand(commandLine, RunCommand.NAME).setStopAtPositional(true);
        appendToHelp(commandLine, DemoCommand.NAME, () -> "Options of the agent:%n" + Options.help());
        appendToHelp(commandLine, RunCommand.NAME, () -> "Options of the agent:%n" + Options.help());
        appendToHelp(commandLine, SimulatorCommand.NAME, SimulatorCommand::listOfParameters);
        return commandLine;
    }

    /** Lists that other modules know stand at the end of a command's help, as they are. */
    private static void appendToHelp(CommandLine commandLine, String command, Supplier<String> list) {
        UsageMessageSpec usage =
                subcommand(commandLine, command).getCommandSpec().usageMessage();
        usage.sectionMap().put("list", help -> String.format("%n" + list.get() + "%n"));
        usage.sectionKeys(
                Stream.concat(usage.sectionKeys().stream(), Stream.of("list")).toList());
    }

    private static CommandLine subcommand(CommandLine commandLine, String name) {
        return Objects.requireNonNull(commandLine.getSubcommands().get(name));
    }

    /** Options without a command belong to the demo: {@code robonewbie --seed 3}. */
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
}
