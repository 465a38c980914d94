package org.robonewbie.nao.motion;

import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;

/**
 * Converts the bytes of a motion file to text and back to the same bytes: UTF-8, or Latin-1 for old files that are not UTF-8,
 * with or without a byte order mark.
 */
record MotionText(Charset charset, String byteOrderMark, String content) {

    static final MotionText EMPTY = new MotionText(StandardCharsets.UTF_8, "", "");

    private static final String MARK = "\uFEFF";

    static MotionText of(byte[] bytes) {
        String content;
        Charset charset = StandardCharsets.UTF_8;
        try {
            content = charset.newDecoder().decode(ByteBuffer.wrap(bytes)).toString();
        } catch (CharacterCodingException noUnicode) {
            charset = StandardCharsets.ISO_8859_1;
            content = new String(bytes, charset);
        }
        return content.startsWith(MARK)
                ? new MotionText(charset, MARK, content.substring(MARK.length()))
                : new MotionText(charset, "", content);
    }

    byte[] encode(String text) {
        Charset sufficient = charset.newEncoder().canEncode(text) ? charset : StandardCharsets.UTF_8;
        return text.getBytes(sufficient);
    }

    List<MotionLine> parse() {
        List<MotionLine> lines = new ArrayList<>();
        int start = 0;
        while (start < content.length()) {
            int end = start;
            while (end < content.length() && content.charAt(end) != '\n' && content.charAt(end) != '\r') {
                end++;
            }
            String lineEnd = lineEndAt(end);
            lines.add(MotionLineParser.parse(content.substring(start, end), lineEnd));
            start = end + lineEnd.length();
        }
        return lines;
    }

    private String lineEndAt(int at) {
        if (content.startsWith("\r\n", at)) {
            return "\r\n";
        }
        return at < content.length() ? content.substring(at, at + 1) : "";
    }
}
