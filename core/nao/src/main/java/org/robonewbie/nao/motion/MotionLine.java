package org.robonewbie.nao.motion;

import java.util.Optional;

/** One line of a motion file with its original text. */
sealed interface MotionLine {

    /** The characters of the line without its end. */
    String text();

    /** The line end as it was: {@code \n}, {@code \r\n}, {@code \r} or nothing. */
    String lineEnd();

    /** A line without a keyframe: empty or a comment. */
    record Note(String text, String lineEnd) implements MotionLine {

        private static final String MARK = "//";

        /** The value of a comment such as {@code // author: Ada}. */
        Optional<String> property(String key) {
            String trimmed = text.strip();
            if (!trimmed.startsWith(MARK)) {
                return Optional.empty();
            }
            String comment = trimmed.substring(MARK.length()).strip();
            return comment.startsWith(key + ":")
                    ? Optional.of(comment.substring(key.length() + 1).strip())
                    : Optional.empty();
        }

        static Note ofProperty(String key, String value, String lineEnd) {
            return new Note(MARK + " " + key + ": " + value, lineEnd);
        }
    }

    /** A line that holds a keyframe. */
    record Frame(String text, String lineEnd, Keyframe keyframe) implements MotionLine {}

    /** A line that should hold a keyframe but does not; kept as it is. */
    record Unreadable(String text, String lineEnd, int column, String problem) implements MotionLine {}
}
