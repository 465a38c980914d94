package org.robonewbie.app.command;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.concurrent.Callable;
import java.util.regex.Pattern;
import org.robonewbie.programs.CalledWronglyException;
import org.robonewbie.programs.ClassPath;
import org.robonewbie.programs.project.NewProject;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code robonewbie new}: creates a project. */
@Command(
        name = "new",
        description = {
            "Create a project of your own: a folder with an agent, a motion, a test and all of RoboNewbie.",
            "It opens in any IDE as a Maven or Gradle project, and also runs without an IDE."
        },
        footer = {
            "",
            "Examples:",
            "  robonewbie new my-team",
            "  robonewbie new my-team --package org.example.soccer",
            "  robonewbie new my-team --build gradle",
            "  robonewbie new my-team --from team        starts from the example team",
            "  robonewbie new my-team --robot T1         plays on the server of today's league",
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
            description = "Package of your classes (default: derived from the name).")
    private String packageName = "";

    @Option(names = "--build", paramLabel = "TOOL", description = "Build tool: maven or gradle (default: maven).")
    private NewProject.BuildTool tool = NewProject.BuildTool.MAVEN;

    @Option(
            names = "--from",
            paramLabel = "ORIGIN",
            description = "Initial content: agent, or team for a copy of the example team (default: agent).")
    private NewProject.Origin origin = NewProject.Origin.AGENT;

    @Option(
            names = "--robot",
            paramLabel = "ROBOT",
            description = "The robot: NAO, or T1 for the server of today's league (default: NAO).")
    private NewProject.Robot robot = NewProject.Robot.NAO;

    @Override
    public Integer call() throws IOException {
        String folder = Path.of(name).getFileName().toString();
        if (!NAME.matcher(folder).matches()) {
            throw new CalledWronglyException(
                    "\"" + folder + "\" is not a valid project name. Use letters, digits and -, such as my-team.");
        }
        String chosen =
                packageName.isEmpty() ? folder.toLowerCase(Locale.ROOT).replaceAll("[^a-z0-9]", "") : packageName;
        if (!PACKAGE.matcher(chosen).matches()) {
            throw new CalledWronglyException("\"" + chosen
                    + "\" is not a valid package name. Use lower-case letters and dots, such as org.example.team.");
        }
        Path project = Path.of(name);
        if (Files.exists(project)) {
            throw new CalledWronglyException(
                    "The folder " + name + " already exists and was not changed. Choose another name.");
        }
        ClassPath.obstacle(project).ifPresent(character -> {
            throw new CalledWronglyException(
                    "Maven, Gradle and the Java tools cannot build a project in a folder whose path contains the"
                            + " character \"" + character + "\": " + project.toAbsolutePath()
                            + ". Create it in another folder.");
        });
        Path jar = ownJar();
        new NewProject(folder, chosen, tool, origin, robot, jar, ProgramVersion.of(jar)).create(project);
        System.out.println("Created the project " + project.toAbsolutePath() + System.lineSeparator()
                + "Next steps: cd " + name + System.lineSeparator()
                + "            ./robonewbie   (on Windows: robonewbie)" + System.lineSeparator()
                + "or open the folder in your IDE as a " + (tool == NewProject.BuildTool.MAVEN ? "Maven" : "Gradle")
                + " project. Its README.md explains the rest.");
        return ExitCode.OK;
    }

    /** Returns this program's jar, preferably that of a local build, because its sources jar is in the same folder. */
    private static Path ownJar() {
        Path built = Path.of(System.getProperty("robonewbie.home", ""), "app", "target", "robonewbie.jar");
        return Files.isRegularFile(built) ? built : ClassPath.ownJar().orElse(built);
    }
}
