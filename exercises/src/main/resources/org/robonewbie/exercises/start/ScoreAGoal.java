import org.robonewbie.agent.Agent;
import org.robonewbie.agent.perception.FieldItem;

/** Score a goal within 3 minutes. */
public class ScoreAGoal extends Agent {

    public static void main(String[] args) {
        new ScoreAGoal().run(args);
    }

    @Override
    protected void think() {
        lookAround.look();
        FieldItem ball = fieldView.ball();
        if (!motions.isFinished()) {
            return;
        }
        if (ball.isKnown() && ball.distance() > 0.6) {
            motions.start(Math.abs(ball.bearing()) < 10 ? "walk-forward"
                    : ball.bearing() > 0 ? "turn-left-small" : "turn-right-small");
        }
        // and where is the goal?
    }
}
