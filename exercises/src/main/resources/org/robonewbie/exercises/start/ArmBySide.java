import org.robonewbie.agent.Agent;
import org.robonewbie.nao.Joint;

/** Raise the arm on whose side another robot is seen. */
public class ArmBySide extends Agent {

    public static void main(String[] args) {
        new ArmBySide().run(args);
    }

    @Override
    protected void think() {
        boolean seen = fieldView.players().stream().anyMatch(player -> player.isVisible());
        nao.setJointAngle(Joint.LEFT_SHOULDER_PITCH, seen ? 90 : 0); // and the right arm?
    }
}
