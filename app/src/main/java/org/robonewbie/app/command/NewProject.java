package org.robonewbie.app.command;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Objects;
import org.robonewbie.app.program.CalledWronglyException;
import org.robonewbie.nao.motion.file.MotionFiles;
import org.robonewbie.nao.motion.file.ShippedMotions;

/**
 * The files of a student's own project. It contains RoboNewbie as one jar, since no public repository has it: so the project
 * works in each IDE, without a network, and with the version with which the course began.
 */
final class NewProject {

    private final String name;
    private final String packageName;
    private final Path jar;

    /**
     * Plans a project.
     *
     * @param name name of the project
     * @param packageName package of its classes
     * @param jar the program of RoboNewbie
     */
    NewProject(String name, String packageName, Path jar) {
        this.name = name;
        this.packageName = packageName;
        this.jar = jar;
    }

    /**
     * Writes all files.
     *
     * @throws CalledWronglyException if RoboNewbie has not been built
     */
    void create(Path project) throws IOException {
        if (!Files.isRegularFile(jar)) {
            throw new CalledWronglyException("A project needs the file " + jar
                    + ", which is not there. Start ./robonewbie once; that builds it.");
        }
        write("pom.xml", project.resolve("pom.xml"));
        write("README.md", project.resolve("README.md"));
        write("gitignore", project.resolve(".gitignore"));
        write("robonewbie.cmd", project.resolve("robonewbie.cmd"));
        write("robonewbie", project.resolve("robonewbie"));
        boolean executable = project.resolve("robonewbie").toFile().setExecutable(true);
        if (!executable) {
            System.err.println("The file robonewbie could not be made executable; start it by: sh robonewbie");
        }
        write("MyAgent.java", project.resolve("src/main/java").resolve(folder()).resolve("MyAgent.java"));
        write(
                "MyAgentTest.java",
                project.resolve("src/test/java").resolve(folder()).resolve("MyAgentTest.java"));
        Files.createDirectories(project.resolve("motions"));
        MotionFiles.save(ShippedMotions.file("wave"), project.resolve("motions/greet.txt"));
        Files.createDirectories(project.resolve("lib"));
        Files.copy(jar, project.resolve("lib/robonewbie.jar"));
    }

    private String folder() {
        return packageName.replace('.', '/');
    }

    private void write(String template, Path file) throws IOException {
        String text = read(template)
                .replace("{{name}}", name)
                .replace("{{package}}", packageName)
                .replace("{{folder}}", folder());
        Files.createDirectories(Objects.requireNonNull(file.getParent()));
        Files.writeString(file, template.endsWith(".cmd") ? text.replace("\n", "\r\n") : text);
    }

    private static String read(String template) throws IOException {
        try (InputStream stream = Objects.requireNonNull(
                NewProject.class.getResourceAsStream("project/" + template + ".txt"),
                "There is no template " + template)) {
            return new String(stream.readAllBytes(), StandardCharsets.UTF_8);
        }
    }
}
