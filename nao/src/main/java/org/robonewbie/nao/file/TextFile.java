package org.robonewbie.nao.file;

import java.nio.file.Path;
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

    private static DecodedText decode(Path file, byte[] bytes) throws UnreadableFileException {
        try {
            return DecodedText.of(bytes);
        } catch (UndecodableTextException undecodable) {
            throw new UnreadableFileException(file, "cannot be read: " + undecodable.getMessage(), undecodable);
        }
    }
}
