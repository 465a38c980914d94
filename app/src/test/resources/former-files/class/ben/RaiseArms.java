import org.robonewbie.agent.Agent;
import org.robonewbie.nao.Joint;

/** Raise the left arm to 60 degrees and the right arm to 45 degrees. */
public class RaiseArms extends Agent {

    public static void main(String[] args) {
        new RaiseArms().run(args);
    }

    @Override
    protected void think()  {
        double left = nao.getJointAngle(Joint.LEFT_SHOULDER_PITCH); // degrees
        nao.setJointSpeed(Joint.LEFT_SHOULDER_PITCH, left < 30 ? 60 : 0); // degrees per second
    }
}
