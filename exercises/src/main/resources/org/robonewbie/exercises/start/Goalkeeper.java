import org.robonewbie.agent.Agent;
import org.robonewbie.nao.Joint;

/** Keep the ball out of the goal. */
public class Goalkeeper extends Agent {

    public static void main(String[] args) {
        new Goalkeeper().run(args);
    }

    @Override
    protected void think() {
        nao.setJointAngle(Joint.NECK_YAW, Math.max(-80, Math.min(80, fieldView.ball().bearing())), 180);
        // where will the ball pass, and when?
    }
}
