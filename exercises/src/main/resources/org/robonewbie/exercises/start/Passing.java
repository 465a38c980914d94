import org.robonewbie.agent.Agent;

/** Number 1 passes the ball, number 2 comes to meet it. */
public class Passing extends Agent {

    public static void main(String[] args) {
        new Passing().run(args);
    }

    private boolean passed;

    @Override
    protected void think() {
        if (nao.getNumber() == 1 && !passed) {
            passed = motions.start("pass-left");
        }
        // and number 2?
    }
}
