package org.robonewbie.app.command;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.robonewbie.nao.file.TextFile;
import org.robonewbie.nao.file.UnreadableFileException;
import org.robonewbie.nao.text.ConfusableCharacter;
import org.robonewbie.programs.CalledWronglyException;
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
        Map<String, Integer> lineOf = new HashMap<>();
        List<String> lines = lines(file);
        for (int i = 0; i < lines.size(); i++) {
            String assignment = lines.get(i).replaceFirst("#.*", "").trim();
            if (!assignment.isEmpty()) {
                check(assignment, file + ", line " + (i + 1) + ": ");
                String name = assignment.substring(0, assignment.indexOf('=')).trim();
                Integer before = lineOf.put(name, i + 1);
                if (before != null) {
                    throw new CalledWronglyException(file + ", line " + (i + 1) + ": \"" + name
                            + "\" is already set in line " + before + ". Delete one of the two lines.");
                }
                assignments.add(assignment);
            }
        }
        return assignments;
    }

    private static void check(String assignment, String place) {
        ConfusableCharacter.firstIn(assignment).ifPresent(character -> {
            throw new CalledWronglyException(place + "In \"" + assignment + "\" " + character + ".");
        });
        try {
            SoccerParameters.league().with(assignment);
        } catch (IllegalArgumentException wrong) {
            throw new CalledWronglyException(place + wrong.getMessage());
        }
    }

    private static List<String> lines(Path file) {
        try {
            return TextFile.readAndNote(file).lines();
        } catch (UnreadableFileException unreadable) {
            throw new CalledWronglyException(String.valueOf(unreadable.getMessage()));
        }
    }
}
