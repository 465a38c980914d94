package org.robonewbie.nao.motion;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.text.DecodedText;
import org.robonewbie.nao.text.UndecodableTextException;

/** Converts the bytes of a motion file to lines and back to the same bytes. Bytes that are no text are kept as they are. */
final class MotionText {

    static final MotionText EMPTY = new MotionText(DecodedText.EMPTY, Optional.empty());

    private final DecodedText decoded;
    private final Optional<MotionProblem> problem;

    private MotionText(DecodedText decoded, Optional<MotionProblem> problem) {
        this.decoded = decoded;
        this.problem = problem;
    }

    static MotionText of(byte[] bytes) {
        try {
            return new MotionText(DecodedText.of(bytes), Optional.empty());
        } catch (UndecodableTextException undecodable) {
            String characters = new String(bytes, StandardCharsets.ISO_8859_1);
            MotionProblem problem = new MotionProblem(undecodable.line(), 1, undecodable.problem());
            return new MotionText(DecodedText.EMPTY.withContent(characters), Optional.of(problem));
        }
    }

    /** Why the bytes are no text; empty if they are. */
    Optional<MotionProblem> problem() {
        return problem;
    }

    /** The byte order mark, or nothing. */
    String mark() {
        return decoded.hasByteOrderMark() ? "\uFEFF" : "";
    }

    byte[] encode(String content) {
        return problem.isPresent() ? content.getBytes(StandardCharsets.ISO_8859_1) : decoded.encode(content);
    }

    /** The lines; bytes that are no text make one line that cannot be understood. */
    List<MotionLine> parse() {
        return problem.isPresent()
                ? List.of(new MotionLine.Unreadable(
                        decoded.content(), "", 1, problem.get().text()))
                : parsed(decoded.content());
    }

    private static List<MotionLine> parsed(String content) {
        List<MotionLine> lines = new ArrayList<>();
        int start = 0;
        while (start < content.length()) {
            int end = start;
            while (end < content.length() && content.charAt(end) != '\n' && content.charAt(end) != '\r') {
                end++;
            }
            String lineEnd = lineEndAt(content, end);
            lines.add(MotionLineParser.parse(content.substring(start, end), lineEnd));
            start = end + lineEnd.length();
        }
        return lines;
    }

    private static String lineEndAt(String content, int at) {
        if (content.startsWith("\r\n", at)) {
            return "\r\n";
        }
        return at < content.length() ? content.substring(at, at + 1) : "";
    }
}
