package org.robonewbie.nao.file;

import java.nio.file.Path;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.robonewbie.nao.text.DecodedText;
import org.robonewbie.nao.text.UndecodableTextException;

/**
 * Reads text that people wrote, as their editors, spreadsheets and shells save it; see {@link DecodedText}. Files that only
 * programs write need none of this.
 *
 * <pre>{@code
 * for (String line : TextFile.read(Path.of("teams.properties")).lines()) { ... }
 * }</pre>
 */
public final class TextFile {

    /** The largest file that is read as text, in bytes. */
    public static final int MAX_BYTES = 16 << 20;

    private static final Set<String> NOTED = ConcurrentHashMap.newKeySet();

    private TextFile() {}

    /**
     * Reads a file.
     *
     * @param file the file
     * @return its text
     * @throws UnreadableFileException if it cannot be read or is no text; the message names file, line and what to do
     */
    public static DecodedText read(Path file) throws UnreadableFileException {
        return decode(file, RegularFile.read(file, MAX_BYTES));
    }

    /**
     * Reads a file for a command or a program. Where its encoding had to be inferred, the terminal says so: once for each file
     * and process.
     *
     * @param file the file
     * @return its text
     * @throws UnreadableFileException if it cannot be read or is no text; the message names file, line and what to do
     */
    public static DecodedText readAndNote(Path file) throws UnreadableFileException {
        DecodedText text = read(file);
        text.note()
                .filter(note -> NOTED.add(file.toAbsolutePath() + note))
                .ifPresent(note -> System.err.println("The file " + file + ", " + note));
        return text;
    }

    private static DecodedText decode(Path file, byte[] bytes) throws UnreadableFileException {
        try {
            return DecodedText.of(bytes);
        } catch (UndecodableTextException undecodable) {
            throw new UnreadableFileException(file, "cannot be read: " + undecodable.getMessage(), undecodable);
        }
    }
}
