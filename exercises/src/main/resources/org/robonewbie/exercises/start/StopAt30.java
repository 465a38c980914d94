import org.robonewbie.agent.Agent;
import org.robonewbie.nao.Joint;

/** Stop the left shoulder at 30 degrees, within 1 degree. */
public class StopAt30 extends Agent {

    public static void main(String[] args) {
        new StopAt30().run(args);
    }

    @Override
    protected void think() {
        double angle = nao.getJointAngle(Joint.LEFT_SHOULDER_PITCH);
        nao.setJointSpeed(Joint.LEFT_SHOULDER_PITCH, angle < 30 ? 150 : 0); // it goes too far: why?
    }
}
