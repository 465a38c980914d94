package org.robonewbie.app.command;

import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.InvalidPathException;
import java.nio.file.NoSuchFileException;
import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.file.PathEncoding;
import org.robonewbie.nao.file.UnreadableFileException;
import org.robonewbie.nao.text.ConfusableCharacter;
import org.robonewbie.nao.text.Spelling;
import org.robonewbie.programs.CalledWronglyException;
import picocli.CommandLine;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.IExecutionExceptionHandler;
import picocli.CommandLine.IParameterExceptionHandler;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.UnmatchedArgumentException;

/** Error reporter: prints one or two plain sentences about what failed and what to write instead. */
final class PlainMessages implements IParameterExceptionHandler, IExecutionExceptionHandler {

    @Override
    public int handleParseException(ParameterException exception, String[] arguments) {
        CommandLine command = exception.getCommandLine();
        command.getErr().println("robonewbie: " + ProgramName.here().in(messageOf(exception)));
        command.getErr()
                .println(ProgramName.here()
                        .in("\"" + command.getCommandSpec().qualifiedName() + " --help\" shows the usage."));
        return ExitCode.USAGE;
    }

    @Override
    public int handleExecutionException(Exception exception, CommandLine command, ParseResult parsed) {
        command.getErr().println("robonewbie: " + ProgramName.here().in(messageOf(exception)));
        return isUserError(exception) ? ExitCode.USAGE : ExitCode.SOFTWARE;
    }

    private static boolean isUserError(Exception exception) {
        return exception instanceof CalledWronglyException
                || exception instanceof UnreadableFileException
                || exception.getCause() instanceof UnreadableFileException;
    }

    /** Explains Java's file exceptions, whose messages are often only a path. */
    private static String messageOf(Exception exception) {
        String message = Optional.ofNullable(exception.getMessage()).orElse(exception.toString());
        if (exception instanceof AccessDeniedException) {
            return "Permission denied: " + message + ". Change to a folder for which you have read and write"
                    + " permission.";
        }
        if (exception instanceof NoSuchFileException) {
            return "There is no file or folder " + message + ".";
        }
        if (exception instanceof InvalidPathException refused) {
            return PathEncoding.explain(refused);
        }
        return exception instanceof FileSystemException ? "File error: " + message + "." : message;
    }

    private static String messageOf(ParameterException exception) {
        return exception instanceof UnmatchedArgumentException unmatched
                ? unknown(unmatched.getUnmatched().get(0), exception.getCommandLine())
                : exception.getMessage() + ".";
    }

    private static String unknown(String argument, CommandLine command) {
        if (argument.startsWith("-")) {
            return "Unknown option " + argument + "." + Spelling.question(argument, optionsOf(command));
        }
        List<String> commands = List.copyOf(command.getSubcommands().keySet());
        return commands.isEmpty()
                ? "Unexpected argument \"" + argument + "\"." + confusable(argument)
                : "Unknown command \"" + argument + "\"." + Spelling.question(argument, commands);
    }

    /** Explains a dash that is not a hyphen, as in options copied from a web page. */
    private static String confusable(String argument) {
        return ConfusableCharacter.firstIn(argument)
                .map(character -> " In it, " + character + ".")
                .orElse("");
    }

    static List<String> optionsOf(CommandLine command) {
        return command.getCommandSpec().options().stream()
                .map(OptionSpec::longestName)
                .toList();
    }
}
