import java.util.List;
import org.robonewbie.agent.Agent;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.motion.Keyframe;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.Posture;

/** Kick the ball with the left foot and stay on your feet. */
public class Kick extends Agent {

    public static void main(String[] args) {
        new Kick().run(args);
    }

    private static final Posture STANCE = Posture.ZERO
            .with(Joint.LEFT_HIP_PITCH, 35)
            .with(Joint.RIGHT_HIP_PITCH, 35)
            .with(Joint.LEFT_KNEE_PITCH, -70)
            .with(Joint.RIGHT_KNEE_PITCH, -70)
            .with(Joint.LEFT_FOOT_PITCH, 37)
            .with(Joint.RIGHT_FOOT_PITCH, 37)
            .with(Joint.LEFT_SHOULDER_PITCH, -90)
            .with(Joint.RIGHT_SHOULDER_PITCH, -90);

    private static final Motion KICK = new Motion(
            "my-kick",
            List.of(
                    new Keyframe(600, STANCE.with(Joint.LEFT_SHOULDER_PITCH, 0)), // where is the weight?
                    new Keyframe(400, STANCE)));

    private boolean kicked;

    @Override
    protected void think() {
        if (!kicked) {
            kicked = motions.start(KICK);
        }
    }
}
