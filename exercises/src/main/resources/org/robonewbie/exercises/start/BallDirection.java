import java.util.Locale;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.perception.FieldItem;

/** Tell the direction of the ball while the head turns. */
public class BallDirection extends Agent {

    public static void main(String[] args) {
        new BallDirection().run(args);
    }

    @Override
    protected void think() {
        lookAround.look();
        FieldItem ball = fieldView.ball();
        if (ball.isVisible()) {
            nao.say(String.format(Locale.ROOT, "ball:%.1f", ball.bearing())); // how wrong is it?
        }
    }
}
