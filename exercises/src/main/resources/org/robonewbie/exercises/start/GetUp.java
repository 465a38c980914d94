import org.robonewbie.agent.Agent;

/** Get up, however the robot lies. */
public class GetUp extends Agent {

    public static void main(String[] args) {
        new GetUp().run(args);
    }

    @Override
    protected void think() {
        motions.setAutomaticGetUp(false); // you decide how to get up
        if (nao.isFallen() && motions.isFinished()) {
            motions.start("stand-up-from-back");
        }
    }
}
