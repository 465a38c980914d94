import org.robonewbie.agent.Agent;
import org.robonewbie.nao.Joint;

/** An agent with a number that can be tuned. */
public class Red extends Agent {
    private final double goal = number("goal", 30, 0, 90);

    public static void main(String[] args) { new Red().run(args); }

    @Override
    protected void think() {
        double angle = nao.getJointAngle(Joint.LEFT_SHOULDER_PITCH);
        nao.setJointSpeed(Joint.LEFT_SHOULDER_PITCH, angle < goal ? 60 : 0);
        log.info("angle %.1f of %.0f", angle, goal);
    }
}
