package org.robonewbie.simulator.script;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.robonewbie.nao.file.TextFile;
import org.robonewbie.nao.file.UnreadableFileException;
import org.robonewbie.nao.text.ConfusableCharacter;
import org.robonewbie.simulator.soccer.SoccerParameters;

/** Text file with one soccer parameter per line, as {@code NAME=VALUE}; {@code #} starts a comment. */
public final class SoccerParameterFile {

    private SoccerParameterFile() {}

    /**
     * Reads a file.
     *
     * @param file the file
     * @return its valid assignments, in file order
     * @throws UnreadableFileException if the file cannot be read or a line is not valid; the message contains the file
     *     name and the line number
     */
    public static List<String> read(Path file) throws UnreadableFileException {
        List<String> assignments = new ArrayList<>();
        Map<String, Integer> lineOf = new HashMap<>();
        List<String> lines = TextFile.readAndNote(file).lines();
        for (int i = 0; i < lines.size(); i++) {
            String assignment = lines.get(i).replaceFirst("#.*", "").trim();
            if (!assignment.isEmpty()) {
                check(assignment, file, i + 1);
                String name = assignment.substring(0, assignment.indexOf('=')).trim();
                Integer before = lineOf.put(name, i + 1);
                if (before != null) {
                    throw UnreadableFileException.atLine(
                            file,
                            i + 1,
                            "\"" + name + "\" is already set in line " + before + ". Delete one of the two lines.");
                }
                assignments.add(assignment);
            }
        }
        return assignments;
    }

    private static void check(String assignment, Path file, int line) throws UnreadableFileException {
        var confusable = ConfusableCharacter.firstIn(assignment);
        if (confusable.isPresent()) {
            throw UnreadableFileException.atLine(file, line, "In \"" + assignment + "\", " + confusable.get() + ".");
        }
        try {
            SoccerParameters.league().with(assignment);
        } catch (IllegalArgumentException invalid) {
            throw UnreadableFileException.atLine(file, line, String.valueOf(invalid.getMessage()));
        }
    }
}
