package org.robonewbie.competition.team;

import java.nio.file.Path;
import java.util.Collection;
import java.util.List;
import java.util.Set;
import org.robonewbie.nao.file.SubmittedFolder;
import org.robonewbie.nao.file.UnreadableFileException;

/** What counts of a team's folder: all files but those that tools have made and those in hidden folders. */
public final class TeamFolder {

    private static final Set<String> MADE_BY_TOOLS =
            Set.of("target", "build", "out", "bin", "node_modules", "__pycache__");

    private TeamFolder() {}

    /**
     * A team's folder as it was handed in.
     *
     * @param folder the folder, or a single file
     * @param foreign folders that may lie in it but do not belong to it: the results of the contest, other teams
     */
    static SubmittedFolder of(Path folder, Collection<Path> foreign) {
        return new SubmittedFolder(folder, place -> isMadeByTools(place) || foreign.contains(absolute(place)));
    }

    /** The files in a fixed order; a file is its own list. */
    static List<Path> filesOf(Path place) throws UnreadableFileException {
        return of(place, List.of()).files();
    }

    /** The path by which folders are compared. */
    static Path absolute(Path place) {
        return place.toAbsolutePath().normalize();
    }

    private static boolean isMadeByTools(Path folder) {
        String name = String.valueOf(folder.getFileName());
        return name.startsWith(".") || MADE_BY_TOOLS.contains(name);
    }
}
