import org.robonewbie.agent.Agent;
import org.robonewbie.nao.Joint;

/** Follow the ball with the head and swing the left arm once in two seconds. */
public class TwoBehaviours extends Agent {

    public static void main(String[] args) {
        new TwoBehaviours().run(args);
    }

    @Override
    protected void think() {
        followTheBall();
        swingTheArm();
    }

    private void followTheBall() {
        // your part: NECK_YAW
    }

    private void swingTheArm() {
        nao.setJointAngle(Joint.LEFT_SHOULDER_PITCH, 45 * Math.sin(nao.getTime())); // too slow
    }
}
