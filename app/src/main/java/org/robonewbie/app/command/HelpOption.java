package org.robonewbie.app.command;

import picocli.CommandLine.Option;

/** The option {@code --help}, the same for each command. */
final class HelpOption {

    @Option(
            names = {"-h", "--help"},
            usageHelp = true,
            description = "Show this text.")
    boolean isWanted;
}
