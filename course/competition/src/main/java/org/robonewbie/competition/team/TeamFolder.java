package org.robonewbie.competition.team;

import java.nio.file.Path;
import java.util.Collection;
import java.util.Set;
import org.robonewbie.nao.file.SubmittedFolder;

/** Selects the files in a team's folder, ignoring build output and hidden folders. */
public final class TeamFolder {

    private static final Set<String> BUILD_OUTPUT =
            Set.of("target", "build", "out", "bin", "node_modules", "__pycache__");

    private TeamFolder() {}

    /**
     * Returns a team's submission.
     *
     * @param folder the folder, or a single file
     * @param foreign folders to ignore, even inside {@code folder}: the contest's results and other teams' folders
     */
    static SubmittedFolder of(Path folder, Collection<Path> foreign) {
        return new SubmittedFolder(folder, place -> isIgnored(place) || foreign.contains(absolute(place)));
    }

    /** Returns the normalised absolute path. */
    static Path absolute(Path place) {
        return place.toAbsolutePath().normalize();
    }

    private static boolean isIgnored(Path folder) {
        String name = String.valueOf(folder.getFileName());
        return name.startsWith(".") || BUILD_OUTPUT.contains(name);
    }
}
