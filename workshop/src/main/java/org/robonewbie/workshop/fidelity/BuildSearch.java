package org.robonewbie.workshop.fidelity;

import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.robonewbie.nao.model.RobotType;

/** Determines the robot type of a recording. */
final class BuildSearch {

    private static final Pattern NAMED =
            Pattern.compile("(?i)nao_hetero\\.rsg[^0-9a-z]{1,4}([0-4])\\b|\\btype\\W{1,4}([0-4])\\b");
    private static final String TOE_HINGE = "llj7";

    private BuildSearch() {}

    /**
     * Returns the possible robot types. Types 0 and 2 stand identically and differ only in their motors, so only a
     * replay can distinguish them.
     *
     * @param recording the recording
     * @return at least one type, the most likely first
     */
    static List<RobotType> candidates(Recording recording) {
        RecordedRow first = recording.runs().get(0).rows().get(0);
        Matcher named = NAMED.matcher(recording.header() + " " + first.sent());
        if (named.find()) {
            String number = named.group(1) == null ? named.group(2) : named.group(1);
            return List.of(RobotType.values()[Integer.parseInt(number)]);
        }
        if (first.jointDegrees().containsKey(TOE_HINGE)) {
            return List.of(RobotType.TYPE_4);
        }
        return List.of(RobotType.TYPE_0, RobotType.TYPE_1, RobotType.TYPE_2, RobotType.TYPE_3);
    }
}
