package org.robonewbie.nao.motion;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;

/** A line of a motion file with its original text, so that everything that is not edited is saved unchanged. */
sealed interface MotionLine {

    /** Returns the characters of the line without its line terminator. */
    String text();

    /** Returns the line terminator: {@code \n}, {@code \r\n}, {@code \r} or nothing. */
    String lineEnd();

    static MotionLine parse(String text, String lineEnd, JointSpace space) {
        List<Word> words = Word.allIn(text);
        if (words.isEmpty()) {
            return new Note(text, lineEnd);
        }
        for (int i = 0; i < words.size(); i++) {
            String problem = words.get(i).problem(i, space);
            if (!problem.isEmpty()) {
                return new Unreadable(text, lineEnd, words.get(i).column() + 1, problem);
            }
        }
        int angles = words.size() - 1;
        if (angles != space.size()) {
            int column = angles > space.size()
                    ? words.get(1 + space.size()).column()
                    : words.get(angles).end();
            String found = angles == 1 ? "1 angle" : angles + " angles";
            return new Unreadable(
                    text,
                    lineEnd,
                    column + 1,
                    found + ", expected " + space.size()
                            + ": write one angle in degrees for each joint after the time in milliseconds");
        }
        double[] degrees = words.stream()
                .skip(1)
                .mapToDouble(word -> Double.parseDouble(word.text()))
                .toArray();
        return new Frame(
                text, lineEnd, new Keyframe(Integer.parseInt(words.get(0).text()), Posture.of(space, degrees)));
    }

    /** A line without a keyframe: empty or a comment. */
    record Note(String text, String lineEnd) implements MotionLine {

        private static final String MARK = "//";

        static Note ofProperty(String key, String value, String lineEnd) {
            return new Note(MARK + " " + key + ": " + value, lineEnd);
        }

        /** Returns the value of a comment such as {@code // author: Ada}. */
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
    }

    /** A line that should hold a keyframe but does not. */
    record Unreadable(String text, String lineEnd, int column, String problem) implements MotionLine {}

    /** A line with a keyframe. */
    record Frame(String text, String lineEnd, Keyframe keyframe) implements MotionLine {

        private static final int CYCLE_MILLIS = 20;
        private static final int MAX_MILLIS = 60_000;

        static Frame of(Keyframe keyframe) {
            StringBuilder text = new StringBuilder();
            text.append(keyframe.durationMillis());
            for (double degrees : keyframe.posture().toArray()) {
                text.append(' ').append(format(degrees));
            }
            return new Frame(text.toString(), "\n", keyframe);
        }

        /** Replaces the keyframe. Unchanged numbers keep their original digits; white space and comments are kept. */
        Frame with(Keyframe changed) {
            List<Word> words = Word.allIn(text);
            StringBuilder line = new StringBuilder();
            int copied = 0;
            for (int i = 0; i < words.size(); i++) {
                Word word = words.get(i);
                line.append(text, copied, word.column());
                line.append(number(word.text(), i, changed));
                copied = word.end();
            }
            return new Frame(line.append(text.substring(copied)).toString(), lineEnd, changed);
        }

        private String number(String original, int index, Keyframe changed) {
            if (index == 0) {
                boolean same = keyframe.durationMillis() == changed.durationMillis();
                return same ? original : Integer.toString(changed.durationMillis());
            }
            double degrees = changed.posture().degrees(index - 1);
            return keyframe.posture().degrees(index - 1) == degrees ? original : format(degrees);
        }

        private static String format(double degrees) {
            return degrees == 0
                    ? "0"
                    : BigDecimal.valueOf(degrees).stripTrailingZeros().toPlainString();
        }

        /**
         * Returns warnings about values that a robot cannot play exactly as written: durations that are not whole
         * cycles, and angles beyond a joint's range.
         */
        List<MotionProblem> warnings(int line) {
            List<Word> words = Word.allIn(text);
            List<MotionProblem> warnings = new ArrayList<>();
            String time = timeWarning(keyframe.durationMillis());
            if (!time.isEmpty()) {
                warnings.add(new MotionProblem(line, words.get(0).column() + 1, time));
            }
            List<JointSpace.Limits> limits = keyframe.posture().jointSpace().joints();
            for (int i = 0; i < limits.size(); i++) {
                JointSpace.Limits joint = limits.get(i);
                double degrees = keyframe.posture().degrees(i);
                if (joint.clampDegrees(degrees) != degrees) {
                    Word word = words.get(1 + i);
                    warnings.add(new MotionProblem(
                            line,
                            word.column() + 1,
                            "angle " + word.text() + " is beyond the range of " + joint.name() + ", expected "
                                    + joint.minDegrees() + " to " + joint.maxDegrees() + " degrees"));
                }
            }
            return warnings;
        }

        private static String timeWarning(int millis) {
            if (millis <= 0) {
                return "time " + millis + " ms is not positive, expected at least " + CYCLE_MILLIS;
            }
            if (millis % CYCLE_MILLIS != 0) {
                return "time " + millis + " ms is not a multiple of the robot's cycle of " + CYCLE_MILLIS
                        + " ms and will be rounded";
            }
            return millis > MAX_MILLIS
                    ? "time " + millis + " ms is longer than a minute; times are in milliseconds"
                    : "";
        }
    }

    /** A word in a line, with its zero-based column. */
    record Word(String text, int column) {

        private static final Pattern DECIMAL = Pattern.compile("[+-]?(\\d+(\\.\\d*)?|\\.\\d+)([eE][+-]?\\d+)?");
        private static final Pattern INTEGER = Pattern.compile("[+-]?\\d{1,9}");

        /** Returns the words before the comment of a line. */
        static List<Word> allIn(String line) {
            int comment = line.indexOf("//");
            int end = comment < 0 ? line.length() : comment;
            List<Word> words = new ArrayList<>();
            int at = 0;
            while (at < end) {
                int start = at;
                while (at < end && !isBlank(line.charAt(at))) {
                    at++;
                }
                if (at > start) {
                    words.add(new Word(line.substring(start, at), start));
                } else {
                    at++;
                }
            }
            return words;
        }

        int end() {
            return column + text.length();
        }

        /**
         * Explains why this word is not a valid number at the given zero-based position in its line; returns an
         * empty string if it is valid.
         */
        String problem(int index, JointSpace space) {
            if (index == 0) {
                return INTEGER.matcher(text).matches()
                        ? ""
                        : "found \"" + text + "\", expected the time in whole milliseconds, such as 500";
            }
            if (DECIMAL.matcher(text).matches() && Double.isFinite(Double.parseDouble(text))) {
                return "";
            }
            String joint = index <= space.size()
                    ? " of " + space.joints().get(index - 1).name()
                    : "";
            return "found \"" + text + "\", expected the angle" + joint + " in degrees, such as -12.5";
        }

        private static boolean isBlank(char character) {
            return character == ' ' || character == '\t';
        }
    }
}
