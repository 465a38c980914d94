package org.robonewbie.nao.motion;

import java.math.BigDecimal;
import java.util.List;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.motion.MotionLineParser.Word;

/** Writes keyframes as lines of a motion file, changing existing lines as little as possible. */
final class MotionLineFormat {

    private MotionLineFormat() {}

    static String format(Keyframe keyframe) {
        StringBuilder text = new StringBuilder();
        text.append(keyframe.durationMillis());
        for (Joint joint : Joint.values()) {
            text.append(' ').append(format(keyframe.posture().degrees(joint)));
        }
        return text.toString();
    }

    /** Replaces the numbers of a line; numbers that stay the same keep their digits, and blanks and comments are kept. */
    static String replace(MotionLine.Frame line, Keyframe keyframe) {
        List<Word> words = MotionLineParser.words(line.text());
        StringBuilder text = new StringBuilder();
        int copied = 0;
        for (int i = 0; i < words.size(); i++) {
            Word word = words.get(i);
            text.append(line.text(), copied, word.column());
            text.append(number(word.text(), i, line.keyframe(), keyframe));
            copied = word.end();
        }
        return text.append(line.text().substring(copied)).toString();
    }

    private static String number(String original, int index, Keyframe before, Keyframe after) {
        if (index == 0) {
            boolean same = before.durationMillis() == after.durationMillis();
            return same ? original : Integer.toString(after.durationMillis());
        }
        Joint joint = Joint.values()[index - 1];
        double degrees = after.posture().degrees(joint);
        return before.posture().degrees(joint) == degrees ? original : format(degrees);
    }

    private static String format(double degrees) {
        return degrees == 0
                ? "0"
                : BigDecimal.valueOf(degrees).stripTrailingZeros().toPlainString();
    }
}
