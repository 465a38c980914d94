package org.robonewbie.programs.project;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.robonewbie.nao.motion.file.MotionFiles;
import org.robonewbie.nao.motion.file.ShippedMotions;
import org.robonewbie.programs.CalledWronglyException;

/**
 * Generates a Maven or Gradle project for a student. Its folder {@code lib} is a Maven repository with RoboNewbie, its
 * sources and its Javadoc, so the project opens in any IDE, builds offline, and keeps using the version with which it was
 * generated.
 */
public final class NewProject {

    private static final String REPOSITORY = "lib";
    private static final List<String> FOR_IDES = List.of("-sources.jar", "-javadoc.jar");

    private final String name;
    private final String packageName;
    private final BuildTool tool;
    private final Origin origin;
    private final Robot robot;
    private final Path jar;
    private final String version;

    /** Initial contents of a project. */
    public enum Origin {
        /** An agent that waves and turns towards the ball. */
        AGENT,
        /** A copy of the example team. */
        TEAM
    }

    /** Robot with which a project plays unless told otherwise. */
    public enum Robot {
        /** The NAO, in RoboNewbie's simulator. */
        NAO,
        /** The Booster T1, on RCSSServerMJ. */
        T1
    }

    /** Build tool of a project. */
    public enum BuildTool {
        /** Maven, with a {@code pom.xml}. */
        MAVEN,
        /** Gradle, with a {@code build.gradle}. */
        GRADLE;

        /** Maps each template to the path of its file in the project. */
        private Map<String, String> files() {
            return this == MAVEN
                    ? Map.of("pom.xml", "pom.xml", "maven.config", ".mvn/maven.config")
                    : Map.of("build.gradle", "build.gradle", "settings.gradle", "settings.gradle");
        }
    }

    /**
     * Creates a generator.
     *
     * @param name project name
     * @param packageName package of the project's classes
     * @param tool build tool
     * @param origin initial contents
     * @param robot its robot
     * @param jar RoboNewbie's jar; the sources and Javadoc jars beside it are included if they exist
     * @param version RoboNewbie's version
     */
    public NewProject(
            String name, String packageName, BuildTool tool, Origin origin, Robot robot, Path jar, String version) {
        this.name = name;
        this.packageName = packageName;
        this.tool = tool;
        this.origin = origin;
        this.robot = robot;
        this.jar = jar;
        this.version = version;
    }

    /**
     * Writes all files.
     *
     * @param project folder in which to create the project
     * @throws CalledWronglyException if {@code jar} does not exist
     * @throws IOException if a file cannot be written
     */
    public void create(Path project) throws IOException {
        if (!Files.isRegularFile(jar)) {
            throw new CalledWronglyException(
                    "A project needs the file " + jar + ", which does not exist. Run ./robonewbie once to build it.");
        }
        for (Map.Entry<String, String> file : tool.files().entrySet()) {
            write(file.getKey(), project.resolve(file.getValue()));
        }
        write("README.md", project.resolve("README.md"));
        write("gitignore", project.resolve(".gitignore"));
        write("robonewbie.cmd", project.resolve("robonewbie.cmd"));
        write("robonewbie", project.resolve("robonewbie"));
        boolean executable = project.resolve("robonewbie").toFile().setExecutable(true);
        if (!executable) {
            System.err.println("The file robonewbie could not be made executable. Start it with: sh robonewbie");
        }
        writeAgent(project.resolve("src/main/java").resolve(folder()));
        Path tests = project.resolve("src/test/java").resolve(folder());
        write("MyAgentTest.java", tests.resolve("MyAgentTest.java"));
        if (robot == Robot.T1) {
            write("t1.properties", project.resolve("robonewbie.properties"));
            write("T1Test.java", tests.resolve("T1Test.java"));
        }
        Files.createDirectories(project.resolve("motions"));
        MotionFiles.save(ShippedMotions.file("wave"), project.resolve("motions/greet.txt"));
        fillRepository(project);
    }

    private void writeAgent(Path folder) throws IOException {
        if (origin == Origin.TEAM) {
            new ExampleTeam(packageName, "MyAgent").write(folder);
        } else {
            write("MyAgent.java", folder.resolve("MyAgent.java"));
        }
    }

    private void fillRepository(Path project) throws IOException {
        Path repository = project.resolve(REPOSITORY)
                .resolve("org/robonewbie/robonewbie")
                .resolve(version)
                .resolve("robonewbie-" + version);
        write("robonewbie.pom", withEnding(repository, ".pom"));
        Files.copy(jar, withEnding(repository, ".jar"));
        Path beside = Path.of(jar.toString().replaceFirst("\\.jar$", ""));
        for (String ending : FOR_IDES) {
            if (Files.isRegularFile(withEnding(beside, ending))) {
                Files.copy(withEnding(beside, ending), withEnding(repository, ending));
            }
        }
    }

    private static Path withEnding(Path file, String ending) {
        return file.resolveSibling(file.getFileName() + ending);
    }

    private String folder() {
        return packageName.replace('.', '/');
    }

    private void write(String template, Path file) throws IOException {
        String text = read(template)
                .replace("{{team}}", origin == Origin.TEAM ? read("team.md") : "")
                .replace("{{t1}}", robot == Robot.T1 ? read("t1.md") : "")
                .replace("{{name}}", name)
                .replace("{{version}}", version)
                .replace("{{build}}", tool == BuildTool.MAVEN ? "mvn" : "gradle")
                .replace("{{package}}", packageName)
                .replace("{{folder}}", folder());
        Files.createDirectories(Objects.requireNonNull(file.getParent()));
        Files.writeString(file, template.endsWith(".cmd") ? text.replace("\n", "\r\n") : text);
    }

    private static String read(String template) throws IOException {
        try (InputStream stream = Objects.requireNonNull(
                NewProject.class.getResourceAsStream(template + ".txt"), "There is no template " + template)) {
            return new String(stream.readAllBytes(), StandardCharsets.UTF_8);
        }
    }
}
