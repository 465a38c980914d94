import org.robonewbie.agent.Agent;

/** Walk once around the ball without touching it. */
public class AroundTheBall extends Agent {

    public static void main(String[] args) {
        new AroundTheBall().run(args);
    }

    @Override
    protected void think() {
        motions.start("side-step-left"); // that is a straight line: turn, too
    }
}
