package org.robonewbie.exercises.task;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.function.Supplier;
import org.robonewbie.exercises.Place;
import org.robonewbie.exercises.Program;
import org.robonewbie.exercises.Puppet;
import org.robonewbie.exercises.Score;
import org.robonewbie.exercises.Stage;
import org.robonewbie.exercises.Task;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;

/**
 * Raise the arm on whose side another robot stands; that robot stands somewhere else every three seconds.
 */
public final class ArmBySideTask implements Task {

    private static final Place STUDENT = new Place(-3, 0, 0);
    private static final double PHASE_SECONDS = 3;
    private static final double JUDGED_FROM_SECONDS = 2;
    private static final double UP_DEGREES = 50;
    private static final double DOWN_DEGREES = 20;

    private final List<Integer> sides = new ArrayList<>(List.of(1, -1, 0, 1, -1, 0));
    private final boolean[] wrong = new boolean[6];
    private int phase = -1;

    /** Creates the task of one trial. */
    public ArmBySideTask() {}

    @Override
    public void begin(Stage stage, Supplier<? extends Program> student) {
        stage.add(student.get(), "Students", 1, STUDENT);
        stage.add(Program.of(new Puppet()), "Others", 2, new Place(-5, 2, 0));
        Collections.shuffle(sides, stage.random());
    }

    @Override
    public void watch(Stage stage) {
        int now = Math.min(sides.size() - 1, (int) (stage.seconds() / PHASE_SECONDS));
        if (now != phase) {
            phase = now;
            stage.players().get(1).moveTo(dummyPlace(stage, sides.get(phase)));
        }
        if (stage.seconds() - phase * PHASE_SECONDS > JUDGED_FROM_SECONDS) {
            double left = stage.student().jointDegrees(Joint.LEFT_SHOULDER_PITCH);
            double right = stage.student().jointDegrees(Joint.RIGHT_SHOULDER_PITCH);
            wrong[phase] |= isWrong(left, sides.get(phase) > 0) || isWrong(right, sides.get(phase) < 0);
        }
    }

    @Override
    public Score score() {
        int right = 0;
        for (boolean bad : wrong) {
            right += bad ? 0 : 1;
        }
        String finding = right + " of " + wrong.length + " times the right arms were up";
        return right == wrong.length
                ? Score.passed(finding)
                : Score.failed(
                        10.0 * right / wrong.length,
                        finding,
                        "fieldView.players() lists who was ever seen: ask isVisible(), and the sign of bearing() for the side."
                                + " Up is above 50°, down below 20°.");
    }

    private static boolean isWrong(double degrees, boolean up) {
        return up ? degrees < UP_DEGREES : degrees > DOWN_DEGREES;
    }

    /** Left, right, or behind the student's robot, where its camera does not see it. */
    private static Place dummyPlace(Stage stage, int side) {
        double distance = stage.between(1.2, 2.2);
        double bearing = side == 0 ? stage.between(150, 210) : side * stage.between(15, 40);
        Vector3 point = STUDENT.point(distance, bearing, 0);
        return new Place(point.x(), point.y(), 180);
    }
}
