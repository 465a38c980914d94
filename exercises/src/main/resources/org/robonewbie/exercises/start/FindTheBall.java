import org.robonewbie.agent.Agent;

/** Look for the ball and face it. */
public class FindTheBall extends Agent {

    public static void main(String[] args) {
        new FindTheBall().run(args);
    }

    @Override
    protected void think() {
        if (!fieldView.ball().isKnown() && motions.isFinished()) {
            motions.start("turn-left");
        }
    }
}
