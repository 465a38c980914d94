package org.robonewbie.exercises;

import java.util.Locale;
import org.robonewbie.nao.Vector3;
import org.robonewbie.trial.Chance;
import org.robonewbie.trial.Moment;
import org.robonewbie.trial.Place;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;

/** Two robots of the student: number 1 plays the ball, number 2 comes to meet it. */
final class PassingTask implements Task {

    private static final double BALL_AHEAD = 0.187;
    private static final double BALL_LEFT = 0.063;
    private static final double FEWEST_METRES = 1;
    private static final double ROLLS_METRES = 0.05;
    private static final double AT_MATE_METRES = 0.45;
    private static final double CAME_METRES = 0.2;
    private static final double STAYED_METRES = 0.4;

    private Place passer = new Place(-2, 0, 0);
    private Place mate = passer;
    private Vector3 ballStart = Vector3.ZERO;
    private double metres;
    private double nearest = Double.POSITIVE_INFINITY;
    private double came;
    private boolean dribbled;
    private boolean tooEarly;
    private boolean fallen;

    @Override
    public Scene scene(Chance chance) {
        passer = new Place(chance.between(-3, -2), chance.between(-1.5, 1.5), chance.between(-40, 40));
        Vector3 place = passer.pointAt(chance.between(2.6, 2.9), chance.between(-0.7, 0.7));
        mate = new Place(place.x(), place.y(), passer.degrees() + 180);
        return Scene.of(
                        RobotStart.at(passer).after("stand"),
                        RobotStart.at(mate).after("stand").withTeam(RobotStart.TEAM, 2))
                .withBall(5.5, 3.7);
    }

    @Override
    public void begin(Trial trial) {
        trial.placeBall(trial.now().place().pointAt(BALL_AHEAD, BALL_LEFT));
        ballStart = trial.ball().position();
    }

    @Override
    public void see(Moment moment) {
        metres = Math.max(metres, moment.ball().distanceTo(ballStart));
        dribbled |= passer.distance(moment.robot().position()) > STAYED_METRES;
        tooEarly |=
                metres < ROLLS_METRES && mate.distance(moment.robots().get(1).position()) > STAYED_METRES;
        came = Math.max(came, mate.distance(moment.robots().get(1).position()));
        if (metres >= FEWEST_METRES && came >= CAME_METRES) {
            nearest = Math.min(nearest, moment.place(1).distance(moment.ball()));
        }
        fallen |= moment.robots().get(1).isFallen() || moment.robot().isFallen();
    }

    @Override
    public boolean isDecided() {
        return nearest <= AT_MATE_METRES;
    }

    private String came(boolean passed) {
        if (!passed) {
            return "";
        }
        return came < CAME_METRES
                ? ", number 2 did not come to meet it"
                : String.format(Locale.ROOT, ", number 2 came as near as %.2f m", nearest);
    }

    @Override
    public Score score() {
        boolean passed = metres >= FEWEST_METRES;
        String finding = String.format(
                Locale.ROOT,
                "the ball went %.2f m%s%s%s%s",
                metres,
                came(passed),
                dribbled ? ", number 1 left its place" : "",
                tooEarly ? ", number 2 walked before the ball rolled" : "",
                fallen ? ", and a fall" : "");
        boolean fair = !dribbled && !tooEarly && !fallen;
        if (fair && nearest <= AT_MATE_METRES) {
            return Score.passed(finding);
        }
        return Score.failed(
                fair && passed ? 3 : 1,
                finding,
                "Both robots run your program: ask nao.getNumber(). Number 1 plays \"pass-left\" and stays where it is; number 2"
                        + " walks to the ball as soon as it rolls.");
    }
}
