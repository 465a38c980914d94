package myteam;

import org.robonewbie.agent.Agent;
import org.robonewbie.agent.Options;
import org.robonewbie.agent.perception.FieldItem;

/** Greets, then keeps its chest towards the ball. Make it yours. */
public class MyAgent extends Agent {

    private boolean greeted;

    public static void main(String[] args) {
        new MyAgent().run(args);
    }

    @Override
    protected Options defaults() {
        return Options.none().withTeam("my-team").withPose(-1, 0.5, 90); // metres, metres, degrees
    }

    @Override
    protected void think() { // 50 times per simulated second
        lookAround.look();
        if (!greeted) {
            greeted = motions.start("greet"); // plays motions/greet.txt
        } else if (motions.isFinished()) {
            turnToTheBall(fieldView.ball());
        }
    }

    private void turnToTheBall(FieldItem ball) {
        if (nao.isFallen()) {
            motions.startGetUp();
        } else if (ball.isKnown() && Math.abs(ball.bearing()) > 10) {
            motions.start(ball.bearing() > 0 ? "turn-left-small" : "turn-right-small");
        }
    }
}
