package org.robonewbie.nao.file;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.robonewbie.nao.text.ConfusableCharacter;

/**
 * Strict reader for files in the format of {@link java.util.Properties}, with one property per line. It rejects duplicate names,
 * single backslashes, which would be lost, and confusable characters.
 *
 * <pre>
 * # a comment
 * team = Red
 * report = C:/runs/red.json
 * headless
 * </pre>
 *
 * <p>Paths are written with {@code /} or with two backslashes. {@code \}{@code u00fc} is the letter ü, as NetBeans writes it.
 */
public final class PropertiesFile {

    private static final Pattern LINE = Pattern.compile("((?:\\\\.|[^\\s=:\\\\])*)\\s*[=:]?\\s*(.*)");
    private static final Pattern ESCAPE = Pattern.compile("\\\\(u\\p{XDigit}{4}|[\\\\:=]|)");

    private final Path file;
    private final Map<String, String> values = new LinkedHashMap<>();
    private final Map<String, Integer> lineOf = new LinkedHashMap<>();

    private PropertiesFile(Path file) {
        this.file = file;
    }

    /**
     * Reads a file. If its encoding was guessed, prints a note to the terminal once.
     *
     * @param file the file
     * @return the values by name, in file order; the value is empty if a line contains only a name
     * @throws UnreadableFileException if the file cannot be read or a line is invalid; the message identifies the file
     *     and line
     */
    public static Map<String, String> read(Path file) throws UnreadableFileException {
        PropertiesFile properties = new PropertiesFile(file);
        List<String> lines = TextFile.readAndNote(file).lines();
        for (int i = 0; i < lines.size(); i++) {
            properties.add(lines.get(i).strip(), i + 1);
        }
        return properties.values;
    }

    private void add(String line, int number) throws UnreadableFileException {
        if (line.isEmpty() || line.startsWith("#") || line.startsWith("!")) {
            return;
        }
        Optional<ConfusableCharacter> confusable = ConfusableCharacter.firstIn(line);
        if (confusable.isPresent()) {
            throw UnreadableFileException.atLine(file, number, "In \"" + line + "\", " + confusable.get() + ".");
        }
        Matcher matcher = LINE.matcher(line);
        if (!matcher.matches()) {
            throw UnreadableFileException.atLine(
                    file, number, "\"" + line + "\" is not a property. Write name = value.");
        }
        String name = unescaped(matcher.group(1), number);
        Integer before = lineOf.put(name, number);
        if (before != null) {
            throw UnreadableFileException.atLine(
                    file,
                    number,
                    "\"" + name + "\" is already set in line " + before + ". Delete one of the two lines.");
        }
        values.put(name, unescaped(matcher.group(2), number));
    }

    private String unescaped(String text, int line) throws UnreadableFileException {
        if (text.matches("\\\\\\\\[^\\\\].*")) {
            throw backslash(text, line);
        }
        StringBuilder plain = new StringBuilder();
        Matcher matcher = ESCAPE.matcher(text);
        while (matcher.find()) {
            String escape = matcher.group(1);
            if (escape.isEmpty()) {
                throw backslash(text, line);
            }
            String character =
                    escape.length() == 1 ? escape : Character.toString(Integer.parseInt(escape.substring(1), 16));
            matcher.appendReplacement(plain, Matcher.quoteReplacement(character));
        }
        return matcher.appendTail(plain).toString();
    }

    private UnreadableFileException backslash(String text, int line) {
        String path = text.replaceAll("\\\\+$", "");
        return UnreadableFileException.atLine(
                file,
                line,
                "In \"" + text + "\", a single backslash would be lost. Write "
                        + path.replaceAll("(?<!^)\\\\+|^\\\\(?!\\\\)", "/").replaceFirst("^\\\\+/?", "//") + " or "
                        + path.replace("\\", "\\\\") + ".");
    }
}
