package org.robonewbie.simulator.script;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robonewbie.nao.file.TextFile;
import org.robonewbie.nao.file.UnreadableFileException;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.script.RubyToken.Kind;

/** Interprets a start script and the scripts that it runs, and reports each ignored setting. */
final class ScriptReader {

    private static final int MAX_REPORTS = 40;
    private static final int MAX_FILES = 50;
    private static final int MAX_NAMES = 5;
    private static final Set<String> ENDINGS = Set.of("exit", "exit!", "abort", "return", "raise");

    private final Console console;
    private final Map<String, Object> values = new LinkedHashMap<>();
    private final Map<String, Object> variables = new HashMap<>();
    private final Deque<Path> running = new ArrayDeque<>();
    private int files;
    private int reports;

    ScriptReader(Console console) {
        this.console = console;
    }

    /** Returns the settings by their SimSpark names, in script order. */
    Map<String, Object> values() {
        return values;
    }

    /** Returns the variables with known values. */
    Map<String, Object> variables() {
        return variables;
    }

    void set(String setting, Object value) {
        values.put(setting, value);
    }

    /**
     * Interprets a script.
     *
     * @throws UnreadableFileException if it cannot be read or sets an invalid value
     */
    void read(Path file) throws UnreadableFileException {
        if (++files > MAX_FILES) {
            throw new UnreadableFileException(
                    "More than " + MAX_FILES + " scripts are nested or run in sequence. Remove some.");
        }
        refuseFolder(file);
        execute(file, TextFile.readAndNote(file).content());
        if (running.isEmpty() && reports > MAX_REPORTS) {
            console.say((reports - MAX_REPORTS) + " more lines are ignored.");
        }
    }

    private static void refuseFolder(Path file) throws UnreadableFileException {
        if (Files.isDirectory(file)) {
            String scripts = scriptsIn(file);
            throw new UnreadableFileException("The start script " + file + " is a folder. Choose a file in it"
                    + (scripts.isEmpty() ? ", such as " + file.resolve("rcssserver3d.rb") : "; it contains " + scripts)
                    + ".");
        }
    }

    private static String scriptsIn(Path folder) {
        try (Stream<Path> all = Files.list(folder)) {
            return all.map(each -> String.valueOf(each.getFileName()))
                    .filter(name -> name.endsWith(".rb"))
                    .sorted()
                    .limit(MAX_NAMES)
                    .collect(Collectors.joining(", "));
        } catch (IOException unreadable) {
            return "";
        }
    }

    private void execute(Path file, String text) throws UnreadableFileException {
        running.push(real(file));
        RubyLexer.Result script = RubyLexer.read(text);
        Optional<RubyStatement> ended = Optional.empty();
        for (RubyStatement statement : RubyStatement.of(script.all())) {
            new ScriptStatement(this, file, statement, ended).execute();
            if (ended.isEmpty() && statement.block().isEmpty() && isEnd(statement.tokens())) {
                ended = Optional.of(statement);
            }
        }
        script.unfinishedLine()
                .ifPresent(line -> report(file + ", line " + line
                        + ": a string starts here and is not terminated; the rest of the file is ignored."));
        running.pop();
    }

    private static boolean isEnd(List<RubyToken> tokens) {
        return tokens.get(0).kind() == Kind.WORD
                && ENDINGS.contains(tokens.get(0).text())
                && tokens.stream().noneMatch(token -> token.isWord("if") || token.isWord("unless"));
    }

    /**
     * Finds a script that is run by another one, first in the folder of the calling script, then in the working
     * directory.
     */
    Optional<Path> find(String script, Path other) {
        try {
            Path beside = Objects.requireNonNull(other.toAbsolutePath().getParent());
            return Stream.of(beside.resolve(script), Path.of(script).toAbsolutePath())
                    .filter(Files::isRegularFile)
                    .findFirst();
        } catch (IllegalArgumentException noPath) {
            return Optional.empty();
        }
    }

    boolean isRunning(Path file) {
        return running.contains(real(file));
    }

    private static Path real(Path file) {
        try {
            return file.toRealPath();
        } catch (IOException gone) {
            return file.toAbsolutePath().normalize();
        }
    }

    void report(String sentence) {
        if (++reports <= MAX_REPORTS) {
            console.say(sentence);
        }
    }
}
