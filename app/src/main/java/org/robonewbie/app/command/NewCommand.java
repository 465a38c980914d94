package org.robonewbie.app.command;

import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.concurrent.Callable;
import java.util.regex.Pattern;
import org.robonewbie.app.program.CalledWronglyException;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Begins a project of a student. */
@Command(
        name = "new",
        description = {
            "Begin a project of your own: a folder with an agent, a motion, a test and all of RoboNewbie.",
            "It opens in any IDE as a Maven project, and runs without one."
        },
        footer = {
            "",
            "Examples:",
            "  robonewbie new my-team",
            "  robonewbie new my-team --package org.example.soccer",
            "then: cd my-team, and ./robonewbie (on Windows: robonewbie)"
        })
final class NewCommand implements Callable<Integer> {

    private static final Pattern NAME = Pattern.compile("[A-Za-z][A-Za-z0-9_-]*");
    private static final Pattern PACKAGE = Pattern.compile("[a-z_][a-z0-9_]*(\\.[a-z_][a-z0-9_]*)*");

    @Mixin
    final HelpOption help = new HelpOption();

    @Parameters(paramLabel = "NAME", description = "Name of the project and its folder, such as my-team.")
    private String name = "";

    @Option(
            names = "--package",
            paramLabel = "PACKAGE",
            description = "Package of your classes (default: from the name).")
    private String packageName = "";

    @Override
    public Integer call() throws IOException {
        String folder = Path.of(name).getFileName().toString();
        if (!NAME.matcher(folder).matches()) {
            throw new CalledWronglyException(
                    "\"" + folder + "\" is no name for a project. Use letters, digits and -, such as my-team.");
        }
        String chosen =
                packageName.isEmpty() ? folder.toLowerCase(Locale.ROOT).replaceAll("[^a-z0-9]", "") : packageName;
        if (!PACKAGE.matcher(chosen).matches()) {
            throw new CalledWronglyException("\"" + chosen
                    + "\" is no name for a package. Use small letters and points, such as org.example.team.");
        }
        Path project = Path.of(name);
        if (Files.exists(project)) {
            throw new CalledWronglyException(
                    "There is a folder " + name + " already, and it is kept. Take another name.");
        }
        new NewProject(folder, chosen, ownJar()).create(project);
        System.out.println("Your project is in " + project.toAbsolutePath() + System.lineSeparator()
                + "Go on with: cd " + name + System.lineSeparator()
                + "            ./robonewbie   (on Windows: robonewbie)" + System.lineSeparator()
                + "or open the folder in your IDE as a Maven project. Its README.md tells more.");
        return ExitCode.OK;
    }

    /** The file in which this program lies. */
    private static Path ownJar() {
        try {
            Path place = Path.of(NewCommand.class
                    .getProtectionDomain()
                    .getCodeSource()
                    .getLocation()
                    .toURI());
            Path built = Path.of(System.getProperty("robonewbie.home", ""), "app", "target", "robonewbie.jar");
            return Files.isRegularFile(place) ? place : built;
        } catch (URISyntaxException impossible) {
            throw new IllegalStateException(impossible);
        }
    }
}
