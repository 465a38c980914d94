import java.util.List;
import org.robonewbie.agent.Agent;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.motion.Interpolation;
import org.robonewbie.nao.motion.Keyframe;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.Posture;

/** Play a motion without jerks: write another interpolation. */
public class SmoothMotion extends Agent {

    public static void main(String[] args) {
        new SmoothMotion().run(args);
    }

    private static final Motion SALUTE = new Motion(
            "salute", List.of(keyframe(400, 60), keyframe(400, -30), keyframe(600, 45), keyframe(400, 0)));

    private boolean played;

    @Override
    protected void think() {
        if (!played) {
            motions.setInterpolation(Interpolation.LINEAR);
            played = motions.start(SALUTE);
        }
    }

    private static Keyframe keyframe(int millis, double degrees) {
        return new Keyframe(millis, Posture.ZERO.with(Joint.LEFT_SHOULDER_PITCH, degrees));
    }
}
