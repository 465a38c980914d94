package org.robonewbie.exercises.task;

import java.util.Locale;
import org.robonewbie.exercises.Score;
import org.robonewbie.exercises.Task;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.trial.Chance;
import org.robonewbie.trial.Moment;
import org.robonewbie.trial.Place;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;

/** Keep a shot out of the goal that would pass the standing robot. */
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
    public Scene scene(Chance chance) {
        double aside = chance.between(-0.5, 0.5);
        aim = chance.side() * chance.between(0.27, 0.35);
        return Scene.of(RobotStart.at(KEEPER).after("stand")).withBall(-1.75, aside);
    }

    @Override
    public void act(Trial trial) {
        if (!shot && trial.seconds() >= SHOT_SECONDS) {
            shot = true;
            Vector3 way = new Vector3(KEEPER.x(), aim, 0).minus(trial.ball().position());
            Vector3 level = new Vector3(way.x(), way.y(), 0);
            trial.ball().setVelocity(level.times(METRES_PER_SECOND / level.length()));
        }
    }

    @Override
    public void see(Moment moment) {
        goal |= moment.goals(TeamSide.RIGHT) > 0 || moment.ball().x() < -6.05;
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
