package org.robonewbie.nao.file;

import java.nio.file.Path;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.robonewbie.nao.text.DecodedText;
import org.robonewbie.nao.text.UndecodableTextException;

/**
 * Reads text files in the encodings that editors, spreadsheets and shells use; see {@link DecodedText}. Intended for
 * files that users edit; files written only by programs are always in UTF-8.
 *
 * <pre>{@code
 * for (String line : TextFile.read(Path.of("teams.properties")).lines()) { ... }
 * }</pre>
 */
public final class TextFile {

    /** Maximum size of a text file in bytes. */
    public static final int MAX_BYTES = 16 << 20;

    private static final Set<String> NOTED = ConcurrentHashMap.newKeySet();

    private TextFile() {}

    /**
     * Reads a file.
     *
     * @param file the file
     * @return its text
     * @throws UnreadableFileException if the file cannot be read or is not text; the message identifies the file and
     *     line, and says what to do
     */
    public static DecodedText read(Path file) throws UnreadableFileException {
        byte[] bytes = RegularFile.read(file, MAX_BYTES);
        try {
            return DecodedText.of(bytes);
        } catch (UndecodableTextException undecodable) {
            throw new UnreadableFileException(file, "cannot be read: " + undecodable.getMessage(), undecodable);
        }
    }

    /**
     * Reads a file. If its encoding was guessed, prints a note to the terminal, once for each file in a process.
     *
     * @param file the file
     * @return its text
     * @throws UnreadableFileException if the file cannot be read or is not text; the message identifies the file and
     *     line, and says what to do
     */
    public static DecodedText readAndNote(Path file) throws UnreadableFileException {
        DecodedText text = read(file);
        text.note()
                .filter(note -> NOTED.add(file.toAbsolutePath() + note))
                .ifPresent(note -> System.err.println("The file " + file + ", " + note));
        return text;
    }
}
