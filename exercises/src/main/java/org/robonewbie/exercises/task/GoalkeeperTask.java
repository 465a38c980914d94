package org.robonewbie.exercises.task;

import java.util.Locale;
import java.util.function.Supplier;
import org.robonewbie.exercises.Place;
import org.robonewbie.exercises.Player;
import org.robonewbie.exercises.Program;
import org.robonewbie.exercises.Score;
import org.robonewbie.exercises.Stage;
import org.robonewbie.exercises.Task;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;

/**
 * Keep a shot out of the goal that would pass beside the standing robot.
 */
public final class GoalkeeperTask implements Task {

    private static final Place KEEPER = new Place(-5.75, 0, 0);
    private static final double SHOT_SECONDS = 2;
    private static final double METRES_PER_SECOND = 6.6;

    private double aim;
    private boolean shot;
    private boolean goal;

    /** Creates the task of one trial. */
    public GoalkeeperTask() {}

    @Override
    public void begin(Stage stage, Supplier<? extends Program> student) {
        Program robot = student.get();
        Player player = stage.add(robot, "Students", 1, KEEPER);
        stage.placeBall(new Vector3(-1.75, stage.between(-0.5, 0.5), 0));
        stage.prelude(player, robot, "stand");
        aim = (stage.random().nextBoolean() ? 1 : -1) * stage.between(0.27, 0.35);
    }

    @Override
    public void watch(Stage stage) {
        if (!shot && stage.seconds() >= SHOT_SECONDS) {
            shot = true;
            Vector3 way = new Vector3(KEEPER.x(), aim, 0).minus(stage.ball().position());
            Vector3 level = new Vector3(way.x(), way.y(), 0);
            stage.ball().setVelocity(level.times(METRES_PER_SECOND / level.length()));
        }
        goal |= stage.game().score(TeamSide.RIGHT) > 0
                || stage.ball().position().x() < -6.05;
    }

    @Override
    public boolean isDecided() {
        return goal;
    }

    @Override
    public Score score() {
        String finding = String.format(
                Locale.ROOT,
                "shot %.2f m to the %s of the goal's centre: %s",
                Math.abs(aim),
                aim > 0 ? "left" : "right",
                goal ? "a goal" : "kept");
        return goal
                ? Score.failed(
                        2,
                        finding,
                        "Two pictures of the ball give its speed and so where it will pass; \"dive-left\" and \"dive-right\""
                                + " are motions.")
                : Score.passed(finding);
    }
}
