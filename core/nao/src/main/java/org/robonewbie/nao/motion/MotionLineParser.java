package org.robonewbie.nao.motion;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import org.robonewbie.nao.Joint;

/** Splits a line of a motion file into its numbers and reports where one is wrong. */
final class MotionLineParser {

    private static final int NUMBERS = 1 + Joint.COUNT;
    private static final Pattern DECIMAL = Pattern.compile("[+-]?(\\d+(\\.\\d*)?|\\.\\d+)([eE][+-]?\\d+)?");
    private static final Pattern INTEGER = Pattern.compile("[+-]?\\d{1,9}");

    private MotionLineParser() {}

    /** A word of a line; the column counts from 0. */
    record Word(String text, int column) {

        int end() {
            return column + text.length();
        }
    }

    static MotionLine parse(String text, String lineEnd) {
        List<Word> words = words(text);
        if (words.isEmpty()) {
            return new MotionLine.Note(text, lineEnd);
        }
        for (int i = 0; i < words.size(); i++) {
            Word word = words.get(i);
            String problem = problem(i, word.text());
            if (!problem.isEmpty()) {
                return new MotionLine.Unreadable(text, lineEnd, word.column() + 1, problem);
            }
        }
        if (words.size() != NUMBERS) {
            return wrongCount(text, lineEnd, words);
        }
        return new MotionLine.Frame(text, lineEnd, keyframe(words));
    }

    /** The words before a comment. */
    static List<Word> words(String text) {
        int comment = text.indexOf("//");
        int end = comment < 0 ? text.length() : comment;
        List<Word> words = new ArrayList<>();
        int at = 0;
        while (at < end) {
            int start = at;
            while (at < end && !isBlank(text.charAt(at))) {
                at++;
            }
            if (at > start) {
                words.add(new Word(text.substring(start, at), start));
            } else {
                at++;
            }
        }
        return words;
    }

    private static boolean isBlank(char character) {
        return character == ' ' || character == '\t';
    }

    private static String problem(int index, String word) {
        if (index == 0) {
            return INTEGER.matcher(word).matches()
                    ? ""
                    : "found \"" + word + "\", expected the time in whole milliseconds, such as 500";
        }
        if (DECIMAL.matcher(word).matches() && Double.isFinite(Double.parseDouble(word))) {
            return "";
        }
        String joint = index < NUMBERS ? " of " + Joint.values()[index - 1] : "";
        return "found \"" + word + "\", expected the angle" + joint + " in degrees, such as -12.5";
    }

    private static MotionLine wrongCount(String text, String lineEnd, List<Word> words) {
        int angles = words.size() - 1;
        int column = angles > Joint.COUNT
                ? words.get(NUMBERS).column() + 1
                : words.get(words.size() - 1).end() + 1;
        return new MotionLine.Unreadable(
                text,
                lineEnd,
                column,
                (angles == 1 ? "1 angle" : angles + " angles") + ", expected " + Joint.COUNT
                        + ": after the time in milliseconds comes one angle in degrees for each joint");
    }

    private static Keyframe keyframe(List<Word> words) {
        double[] degrees = new double[Joint.COUNT];
        for (int i = 0; i < degrees.length; i++) {
            degrees[i] = Double.parseDouble(words.get(i + 1).text());
        }
        return new Keyframe(Integer.parseInt(words.get(0).text()), Posture.of(degrees));
    }
}
