import org.robonewbie.agent.Agent;
import org.robonewbie.nao.Joint;

/** Dance with arms, head and legs, and stay on your feet. */
public class MyDance extends Agent {

    public static void main(String[] args) {
        new MyDance().run(args);
    }

    @Override
    protected void think() {
        double swing = 60 * Math.sin(2 * Math.PI * nao.getTime() / 2); // once in two seconds
        nao.setJointAngle(Joint.LEFT_SHOULDER_PITCH, swing, 200);
        nao.setJointAngle(Joint.RIGHT_SHOULDER_PITCH, -swing, 200);
    }
}
