package org.robonewbie.exercises.task;

import java.util.EnumMap;
import java.util.Map;
import org.robonewbie.exercises.Score;
import org.robonewbie.exercises.Task;
import org.robonewbie.nao.Joint;
import org.robonewbie.trial.Chance;
import org.robonewbie.trial.Moment;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;

/**
 * Dance: many joints, many changes of direction, no fall.
 */
public final class DanceTask implements Task {

    private static final double WIDE_DEGREES = 30;
    private static final int FEWEST_JOINTS = 6;
    private static final int FEWEST_TURNS = 12;
    private static final double REAL_TURN_DEGREES = 10;

    private final Map<Joint, double[]> ranges = new EnumMap<>(Joint.class);
    private final Map<Joint, double[]> turns = new EnumMap<>(Joint.class);
    private boolean fallen;
    private boolean standing;

    /** Creates the task of one trial. */
    public DanceTask() {}

    @Override
    public Scene scene(Chance chance) {
        return Scene.of(RobotStart.at(-1, 0).after("stand"));
    }

    @Override
    public void see(Moment moment) {
        for (Joint joint : Joint.values()) {
            double degrees = moment.robot().degrees(joint);
            double[] range = ranges.computeIfAbsent(joint, key -> new double[] {degrees, degrees});
            range[0] = Math.min(range[0], degrees);
            range[1] = Math.max(range[1], degrees);
            double[] turn = turns.computeIfAbsent(joint, key -> new double[] {degrees, 0, 0});
            follow(turn, degrees);
        }
        fallen |= moment.robot().isFallen();
        standing = moment.robot().isStanding();
    }

    @Override
    public boolean isDecided() {
        return fallen;
    }

    @Override
    public Score score() {
        long joints = ranges.values().stream()
                .filter(range -> range[1] - range[0] >= WIDE_DEGREES)
                .count();
        int changes = (int) turns.values().stream().mapToDouble(turn -> turn[2]).sum();
        String finding = joints + " joints moved 30° or more, " + changes + " changes of direction"
                + (fallen ? ", and a fall" : "");
        if (fallen || !standing) {
            return Score.failed(
                    (double) Math.min(3, joints),
                    finding,
                    "Move the legs slowly and alike on both sides; arms and head are free.");
        }
        boolean rich = joints >= FEWEST_JOINTS && changes >= FEWEST_TURNS;
        return rich
                ? Score.passed(finding)
                : Score.failed(
                        Math.min(9.0, joints + changes / 6.0),
                        finding,
                        "The audience wants at least 6 joints that move 30° or more, and 12 changes of direction.");
    }

    /** Counts when a joint turns back by more than a trifle: the extreme angle so far, the direction, the turns. */
    private static void follow(double[] turn, double degrees) {
        double direction = Math.signum(degrees - turn[0]);
        if (direction == turn[1]) {
            turn[0] = degrees;
        } else if (Math.abs(degrees - turn[0]) > REAL_TURN_DEGREES) {
            turn[2] += turn[1] == 0 ? 0 : 1;
            turn[0] = degrees;
            turn[1] = direction;
        }
    }
}
