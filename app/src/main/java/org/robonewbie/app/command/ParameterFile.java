package org.robonewbie.app.command;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.robonewbie.app.program.CalledWronglyException;
import org.robonewbie.simulator.soccer.SoccerParameters;

/** A small text file with one {@code NAME=VALUE} per line; what follows {@code #} is a comment. */
final class ParameterFile {

    private ParameterFile() {}

    /**
     * Reads a file.
     *
     * @param file the file
     * @return its assignments in their order, each of which is possible
     * @throws CalledWronglyException if the file cannot be read or a line cannot be understood; the message names it
     */
    static List<String> read(Path file) {
        List<String> assignments = new ArrayList<>();
        List<String> lines = lines(file);
        for (int i = 0; i < lines.size(); i++) {
            String assignment = lines.get(i).replaceFirst("#.*", "").trim();
            if (!assignment.isEmpty()) {
                check(assignment, file + ", line " + (i + 1) + ": ");
                assignments.add(assignment);
            }
        }
        return assignments;
    }

    private static void check(String assignment, String place) {
        try {
            SoccerParameters.league().with(assignment);
        } catch (IllegalArgumentException wrong) {
            throw new CalledWronglyException(place + wrong.getMessage());
        }
    }

    private static List<String> lines(Path file) {
        try {
            return Files.readAllLines(file);
        } catch (IOException unreadable) {
            throw new CalledWronglyException("The file of parameters " + file
                    + " cannot be read. Is its name and folder right, and is it a text file?");
        }
    }
}
