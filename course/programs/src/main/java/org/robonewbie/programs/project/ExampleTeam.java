package org.robonewbie.programs.project;

import java.io.IOException;
import java.net.URL;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.stream.Stream;
import org.robonewbie.programs.CalledWronglyException;
import org.robonewbie.programs.ResourceFolder;

/** Copies the example team's sources, adapting them to the package and agent name of a student's project. */
final class ExampleTeam {

    private static final String PACKAGE = "org.robonewbie.team";
    private static final String FOLDER = "META-INF/sources/" + PACKAGE.replace('.', '/');
    private static final String AGENT = "Agent_Team";

    private final String packageName;
    private final String agentName;

    ExampleTeam(String packageName, String agentName) {
        this.packageName = packageName;
        this.agentName = agentName;
    }

    /**
     * Writes the sources to a package folder.
     *
     * @throws CalledWronglyException if this build does not contain them
     */
    void write(Path folder) throws IOException {
        URL sources = ExampleTeam.class.getClassLoader().getResource(FOLDER);
        if (sources == null) {
            throw new CalledWronglyException(
                    "This build lacks the sources of the example team. Rebuild it by running ./robonewbie --help.");
        }
        ResourceFolder.read(sources, FOLDER, from -> copy(from, folder));
    }

    private void copy(Path from, Path folder) throws IOException {
        List<Path> files;
        try (Stream<Path> walk = Files.walk(from)) {
            files = walk.filter(file -> file.toString().endsWith(".java"))
                    .filter(file -> !file.endsWith("package-info.java"))
                    .toList();
        }
        for (Path file : files) {
            String relative = from.relativize(file).toString().replace(AGENT, agentName);
            Path target = folder.resolve(relative);
            Files.createDirectories(Objects.requireNonNull(target.getParent()));
            Files.writeString(target, adapted(Files.readString(file)));
        }
    }

    private String adapted(String text) {
        return text.replace(PACKAGE, packageName).replace(AGENT, agentName);
    }
}
