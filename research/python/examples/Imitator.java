import java.nio.file.Path;
import java.util.Locale;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.PolicyPlayer;
import org.robonewbie.agent.policy.file.PolicyFile;
import org.robonewbie.nao.Joint;

/** Plays the policy of imitate.py: the head turns slowly, and prints the wanted and the measured angle. */
public class Imitator extends Agent {

    private final PolicyPlayer policy = new PolicyPlayer(PolicyFile.read(Path.of("Imitate.policy")));
    private int cycle;

    public static void main(String[] args) {
        new Imitator().run(args);
    }

    @Override
    protected void think() {
        double direction = Math.sin(cycle++ / 50.0);
        System.out.printf(
                Locale.ROOT,
                "Head %.1f %.1f%n",
                30 * 0.8 * Math.sin(1.5 * direction),
                nao.getJointAngle(Joint.NECK_YAW));
        policy.setCommand("direction", direction);
        policy.act(nao);
    }
}
