import org.robonewbie.agent.Agent;

/** Say where on the pitch you stand. */
public class WhereAmI extends Agent {

    public static void main(String[] args) {
        new WhereAmI().run(args);
    }

    @Override
    protected void think() {
        lookAround.look();
        nao.say("at:0.00:0.00"); // metres from the centre: x to the right goal, y to the left
    }
}
