import org.robonewbie.agent.Agent;

/** Walk to the ball, stop before it, raise the left arm. */
public class GoToTheBall extends Agent {

    public static void main(String[] args) {
        new GoToTheBall().run(args);
    }

    @Override
    protected void think() {
        lookAround.look();
        if (motions.isFinished() && fieldView.ball().isKnown()) {
            if (Math.abs(fieldView.ball().bearing()) > 15) {
                motions.start(fieldView.ball().bearing() > 0 ? "turn-left-small" : "turn-right-small");
            }
            // walk to it, stop, raise the arm
        }
    }
}
