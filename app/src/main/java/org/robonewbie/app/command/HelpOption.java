package org.robonewbie.app.command;

import picocli.CommandLine.Option;

/** Option {@code --help}, shared by all commands. */
final class HelpOption {

    @Option(
            names = {"-h", "--help"},
            usageHelp = true,
            description = "Show this help.")
    boolean isWanted;
}
