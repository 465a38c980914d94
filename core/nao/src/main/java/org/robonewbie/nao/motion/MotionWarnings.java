package org.robonewbie.nao.motion;

import java.util.ArrayList;
import java.util.List;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.motion.MotionLineParser.Word;

/** Finds where a robot cannot quite follow a keyframe. */
final class MotionWarnings {

    private static final int CYCLE_MILLIS = 20;
    private static final int LONGEST_MILLIS = 60_000;

    private MotionWarnings() {}

    static List<MotionProblem> of(int line, MotionLine.Frame frame) {
        List<Word> words = MotionLineParser.words(frame.text());
        List<MotionProblem> findings = new ArrayList<>();
        String time = timeWarning(frame.keyframe().durationMillis());
        if (!time.isEmpty()) {
            findings.add(new MotionProblem(line, words.get(0).column() + 1, time));
        }
        for (Joint joint : Joint.values()) {
            double degrees = frame.keyframe().posture().degrees(joint);
            if (joint.clampDegrees(degrees) != degrees) {
                Word word = words.get(1 + joint.ordinal());
                findings.add(new MotionProblem(line, word.column() + 1, angleWarning(joint, word.text())));
            }
        }
        return findings;
    }

    private static String timeWarning(int millis) {
        if (millis <= 0) {
            return "time " + millis + " ms is not positive, expected at least " + CYCLE_MILLIS;
        }
        if (millis % CYCLE_MILLIS != 0) {
            return "time " + millis + " ms is no multiple of " + CYCLE_MILLIS
                    + ", the robot's cycle; it is played in whole cycles";
        }
        return millis > LONGEST_MILLIS
                ? "time " + millis + " ms is longer than a minute; milliseconds are expected"
                : "";
    }

    private static String angleWarning(Joint joint, String degrees) {
        return "angle " + degrees + " is beyond the range of " + joint + ", expected " + joint.minDegrees() + " to "
                + joint.maxDegrees() + " degrees";
    }
}
