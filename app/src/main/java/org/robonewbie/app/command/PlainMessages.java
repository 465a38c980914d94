package org.robonewbie.app.command;

import java.util.List;
import java.util.Optional;
import org.robonewbie.agent.log.Spelling;
import org.robonewbie.app.program.CalledWronglyException;
import picocli.CommandLine;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.IExecutionExceptionHandler;
import picocli.CommandLine.IParameterExceptionHandler;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.UnmatchedArgumentException;

/** Explains in one or two plain sentences what went wrong and what to write instead. */
final class PlainMessages implements IParameterExceptionHandler, IExecutionExceptionHandler {

    @Override
    public int handleParseException(ParameterException exception, String[] arguments) {
        CommandLine command = exception.getCommandLine();
        command.getErr().println("robonewbie: " + messageOf(exception));
        command.getErr()
                .println("\"" + command.getCommandSpec().qualifiedName() + " --help\" shows what can be written.");
        return ExitCode.USAGE;
    }

    @Override
    public int handleExecutionException(Exception exception, CommandLine command, ParseResult parsed) {
        command.getErr()
                .println("robonewbie: "
                        + Optional.ofNullable(exception.getMessage()).orElse(exception.toString()));
        return exception instanceof CalledWronglyException ? ExitCode.USAGE : ExitCode.SOFTWARE;
    }

    private static String messageOf(ParameterException exception) {
        return exception instanceof UnmatchedArgumentException unmatched
                ? unknown(unmatched.getUnmatched().get(0), exception.getCommandLine())
                : exception.getMessage() + ".";
    }

    private static String unknown(String argument, CommandLine command) {
        if (argument.startsWith("-")) {
            return "The option " + argument + " is unknown." + question(argument, optionsOf(command));
        }
        List<String> commands = List.copyOf(command.getSubcommands().keySet());
        return commands.isEmpty()
                ? "\"" + argument + "\" is too much here."
                : "There is no command \"" + argument + "\"." + question(argument, commands);
    }

    private static List<String> optionsOf(CommandLine command) {
        return command.getCommandSpec().options().stream()
                .map(OptionSpec::longestName)
                .toList();
    }

    private static String question(String written, List<String> names) {
        return Spelling.nearest(written, names)
                .map(name -> " Did you mean " + name + "?")
                .orElse("");
    }
}
