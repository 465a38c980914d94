import org.robonewbie.agent.Agent;

/** Walk as far as you can in 10 seconds. */
public class FasterWalk extends Agent {

    public static void main(String[] args) {
        new FasterWalk().run(args);
    }

    @Override
    protected void think() {
        motions.start("walk-forward");
    }
}
