package org.robonewbie.nao.text;

import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HexFormat;
import java.util.List;
import java.util.Optional;

/**
 * The text of a file with its detected encoding. A byte order mark determines the encoding; without one it is UTF-8, or
 * Windows-1252 if the bytes are not valid UTF-8. {@link #encode} restores the original bytes. Immutable.
 *
 * <pre>{@code
 * DecodedText text = DecodedText.of(bytes);
 * for (String line : text.lines()) { ... }
 * byte[] changed = text.encode(text.content().replace("30", "45"));
 * }</pre>
 *
 * @param encoding encoding of the bytes
 * @param hasByteOrderMark whether the file starts with a byte order mark, which {@code content} does not contain
 * @param content all characters, with the line terminators of the file
 */
public record DecodedText(TextEncoding encoding, boolean hasByteOrderMark, String content) {

    /** Advice about text that cannot be decoded, as a complete sentence. */
    public static final String SAVE_AS_UTF_8 = "Save it as UTF-8 (most editors: Save As, Encoding).";

    private static final HexFormat HEXADECIMAL = HexFormat.of();

    private static final char MARK = '\uFEFF';

    /** The empty text, in UTF-8. */
    public static final DecodedText EMPTY = new DecodedText(TextEncoding.UTF_8, false, "");

    /**
     * Decodes the bytes of a file.
     *
     * @param bytes all bytes of the file
     * @return the text
     * @throws UndecodableTextException if the bytes are not valid in any {@link TextEncoding}
     */
    public static DecodedText of(byte[] bytes) throws UndecodableTextException {
        Optional<String> wide = utf16(bytes);
        if (wide.isPresent()) {
            boolean isLittle = bytes[0] == (byte) 0xFF;
            return marked(isLittle ? TextEncoding.UTF_16_LE : TextEncoding.UTF_16_BE, wide.get());
        }
        try {
            return marked(
                    TextEncoding.UTF_8,
                    StandardCharsets.UTF_8
                            .newDecoder()
                            .decode(ByteBuffer.wrap(bytes))
                            .toString());
        } catch (CharacterCodingException noUnicode) {
            refuseDamagedUtf8(bytes);
            return marked(TextEncoding.WINDOWS_1252, windows1252(bytes));
        }
    }

    /** {@return the lines without their terminators: carriage return, line feed, or both} */
    public List<String> lines() {
        List<String> lines = new ArrayList<>();
        int start = 0;
        for (int i = 0; i < content.length(); i++) {
            if (isLineEnd(content.charAt(i))) {
                lines.add(content.substring(start, i));
                i += content.startsWith("\r\n", i) ? 1 : 0;
                start = i + 1;
            }
        }
        if (start < content.length()) {
            lines.add(content.substring(start));
        }
        return Collections.unmodifiableList(lines);
    }

    /**
     * Returns a note for the user that explains garbled letters, if the encoding was guessed.
     *
     * @return a note such as {@code line 3 is not UTF-8 and was read as Windows-1252: "// grüße". Save it as UTF-8 …}; empty if
     *     the encoding is certain
     */
    public Optional<String> note() {
        if (encoding != TextEncoding.WINDOWS_1252) {
            return Optional.empty();
        }
        List<String> lines = lines();
        int first = 0;
        while (lines.get(first).chars().allMatch(character -> character < 0x80)) {
            first++;
        }
        return Optional.of("line " + (first + 1) + " is not UTF-8 and was read as Windows-1252: \""
                + shortened(lines.get(first).strip()) + "\". " + SAVE_AS_UTF_8);
    }

    /**
     * Encodes changed text in the same way as the original: in the same encoding and with the same byte order mark.
     * Falls back to UTF-8 if that encoding lacks a character, or if the bytes would be decoded differently.
     *
     * @param changed the changed text
     * @return the bytes of the file
     */
    public byte[] encode(String changed) {
        String marked = hasByteOrderMark ? MARK + changed : changed;
        return switch (encoding) {
            case UTF_8 -> marked.getBytes(StandardCharsets.UTF_8);
            case UTF_16_LE -> utf16(marked, 0);
            case UTF_16_BE -> utf16(marked, 1);
            case WINDOWS_1252 ->
                windows1252(marked)
                        .filter(bytes -> decodesTo(marked, bytes))
                        .orElseGet(() -> marked.getBytes(StandardCharsets.UTF_8));
        };
    }

    /**
     * Returns whether bytes decode to a given string. For example, "Ã¼" in Windows-1252 has the same bytes as "ü" in
     * UTF-8.
     */
    private static boolean decodesTo(String text, byte[] bytes) {
        try {
            return of(bytes).content().equals(text);
        } catch (UndecodableTextException other) {
            return false;
        }
    }

    private static DecodedText marked(TextEncoding encoding, String decoded) throws UndecodableTextException {
        int zero = decoded.indexOf('\0');
        if (zero >= 0) {
            throw new UndecodableTextException(
                    lineAt(decoded, zero),
                    "contains a zero byte, as in binary files and in UTF-16 without a byte order mark");
        }
        boolean hasMark = !decoded.isEmpty() && decoded.charAt(0) == MARK;
        return new DecodedText(encoding, hasMark, hasMark ? decoded.substring(1) : decoded);
    }

    /**
     * Rejects mostly valid UTF-8, and invalid UTF-8 after a UTF-8 byte order mark: such a file is damaged, not
     * Windows-1252.
     */
    private static void refuseDamagedUtf8(byte[] bytes) throws UndecodableTextException {
        int letters = 0;
        int wrong = 0;
        int firstWrong = bytes.length;
        int i = 0;
        while (i < bytes.length) {
            int length = utf8Length(bytes, i);
            letters += length > 1 ? 1 : 0;
            wrong += length == 0 ? 1 : 0;
            firstWrong = length == 0 || !isScalar(bytes, i, length) ? Math.min(firstWrong, i) : firstWrong;
            i += Math.max(1, length);
        }
        if (letters > wrong || startsWithMark(bytes)) {
            String before = new String(bytes, 0, firstWrong, StandardCharsets.UTF_8);
            throw new UndecodableTextException(
                    lineAt(before, before.length()), "is not UTF-8, though the rest of the file is: it is damaged");
        }
    }

    private static boolean startsWithMark(byte[] bytes) {
        return bytes.length >= 3 && bytes[0] == (byte) 0xEF && bytes[1] == (byte) 0xBB && bytes[2] == (byte) 0xBF;
    }

    /** Returns the length in bytes of the UTF-8 sequence at a position; 0 if there is none. */
    private static int utf8Length(byte[] bytes, int at) {
        int lead = bytes[at] & 0xFF;
        int length = lead < 0x80 ? 1 : lead < 0xC2 ? 0 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : lead < 0xF5 ? 4 : 0;
        for (int i = at + 1; i < at + length; i++) {
            if (i >= bytes.length || (bytes[i] & 0xC0) != 0x80) {
                return 0;
            }
        }
        return length;
    }

    /** Returns whether a UTF-8 sequence encodes a scalar value: neither a surrogate, nor overlong, nor out of range. */
    private static boolean isScalar(byte[] bytes, int at, int length) {
        int second = length < 3 ? 0 : bytes[at + 1] & 0xFF;
        return switch (length < 3 ? 0 : bytes[at] & 0xFF) {
            case 0xE0 -> second >= 0xA0;
            case 0xED -> second < 0xA0;
            case 0xF0 -> second >= 0x90;
            case 0xF4 -> second < 0x90;
            default -> true;
        };
    }

    private static Optional<String> utf16(byte[] bytes) throws UndecodableTextException {
        int first = bytes.length < 2 ? 0 : char16(bytes, 0, 1);
        if (first != 0xFEFF && first != 0xFFFE) {
            return Optional.empty();
        }
        int high = first == 0xFEFF ? 0 : 1;
        char[] characters = new char[bytes.length / 2];
        for (int i = 0; i < characters.length; i++) {
            characters[i] = (char) char16(bytes, 2 * i + high, 2 * i + 1 - high);
        }
        String decoded = new String(characters);
        int wrong = bytes.length % 2 == 1 ? characters.length : unpairedSurrogate(decoded);
        if (wrong >= 0) {
            throw new UndecodableTextException(lineAt(decoded, wrong), "ends within a UTF-16 character");
        }
        return Optional.of(decoded);
    }

    private static int char16(byte[] bytes, int high, int low) {
        return ((bytes[high] & 0xFF) << 8) | (bytes[low] & 0xFF);
    }

    private static int unpairedSurrogate(String text) {
        for (int i = 0; i < text.length(); i++) {
            if (Character.isSurrogate(text.charAt(i))) {
                boolean isPair = i + 1 < text.length() && Character.isSurrogatePair(text.charAt(i), text.charAt(i + 1));
                if (!isPair) {
                    return i;
                }
                i++;
            }
        }
        return -1;
    }

    private static byte[] utf16(String text, int low) {
        byte[] bytes = new byte[2 * text.length()];
        for (int i = 0; i < text.length(); i++) {
            bytes[2 * i + low] = (byte) text.charAt(i);
            bytes[2 * i + 1 - low] = (byte) (text.charAt(i) >> 8);
        }
        return bytes;
    }

    private static String windows1252(byte[] bytes) throws UndecodableTextException {
        StringBuilder text = new StringBuilder(bytes.length);
        for (byte each : bytes) {
            char character = Windows1252.decode(each);
            if (character == '\0') {
                throw new UndecodableTextException(
                        lineAt(text, text.length()),
                        "is neither UTF-8 nor Windows-1252 (byte 0x" + HEXADECIMAL.formatHex(new byte[] {each}) + ")");
            }
            text.append(character);
        }
        return text.toString();
    }

    private static Optional<byte[]> windows1252(String text) {
        byte[] bytes = new byte[text.length()];
        for (int i = 0; i < bytes.length; i++) {
            int code = Windows1252.encode(text.charAt(i));
            if (code < 0) {
                return Optional.empty();
            }
            bytes[i] = (byte) code;
        }
        return Optional.of(bytes);
    }

    private static int lineAt(CharSequence text, int index) {
        int line = 1;
        for (int i = 0; i < Math.min(index, text.length()); i++) {
            boolean isSecondOfPair = text.charAt(i) == '\n' && i > 0 && text.charAt(i - 1) == '\r';
            line += isLineEnd(text.charAt(i)) && !isSecondOfPair ? 1 : 0;
        }
        return line;
    }

    private static boolean isLineEnd(char character) {
        return character == '\n' || character == '\r';
    }

    private static String shortened(String line) {
        int most = 60;
        return line.length() <= most ? line : line.substring(0, most) + "…";
    }
}
