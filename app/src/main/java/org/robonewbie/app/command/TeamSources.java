package org.robonewbie.app.command;

import java.io.IOException;
import java.net.URL;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.stream.Stream;
import org.robonewbie.programs.CalledWronglyException;
import org.robonewbie.programs.ResourceFolder;

/** The texts of the example team, as the beginning of a student's own: in the student's package, with the student's agent. */
final class TeamSources {

    private static final String PACKAGE = "org.robonewbie.team";
    private static final String FOLDER = "META-INF/sources/" + PACKAGE.replace('.', '/');
    private static final String AGENT = "Agent_Team";

    private final String packageName;
    private final String agentName;

    /**
     * Plans a copy.
     *
     * @param packageName package of the copy
     * @param agentName simple name of its agent
     */
    TeamSources(String packageName, String agentName) {
        this.packageName = packageName;
        this.agentName = agentName;
    }

    /**
     * Writes the copy.
     *
     * @param folder the folder of the package
     * @throws CalledWronglyException if the texts do not come along with this program
     */
    void write(Path folder) throws IOException {
        URL sources = TeamSources.class.getClassLoader().getResource(FOLDER);
        if (sources == null) {
            throw new CalledWronglyException(
                    "The texts of the example team are not in this program. Build it: ./robonewbie --help does so.");
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
