package org.robonewbie.app.command;

import picocli.CommandLine.Option;

/** The option {@code --headless} of commands that open no studio anyway, so that it may stand in every call. */
final class WithoutStudioOption {

    @Option(names = "--headless", description = "Without effect: this command opens no studio.")
    boolean isGiven;
}
