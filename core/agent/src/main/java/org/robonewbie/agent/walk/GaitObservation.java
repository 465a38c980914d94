package org.robonewbie.agent.walk;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.stream.Stream;
import org.robonewbie.agent.perception.FootPressure;
import org.robonewbie.agent.perception.TorsoMotion;
import org.robonewbie.agent.policy.Quantity;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.Leg;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.nao.motion.Posture;

/**
 * Observation for a policy that moves the legs by itself: what the sensors read, the tilt that a complementary filter estimates from
 * them, the speeds of the leg joints, the last action, and a clock with the time of a stride, all in units in which they are about -1 to 1.
 *
 * <pre>{@code
 * observation.update(posture, torso, left, right);                  // in each cycle
 * action = network.apply(observation.values(action));
 * }</pre>
 */
public final class GaitObservation {

    /** Values are clipped to this multiple of their unit. */
    public static final double MAX = 5;

    private static final double TILT_DEGREES = 20;
    private static final double GYRO_DEGREES_PER_SECOND = 100;
    private static final double ACCELERATION = 10;
    private static final double OFFSET_DEGREES = 30;
    private static final double SPEED_DEGREES_PER_SECOND = 150;
    private static final double POINT_METRES = 0.1;
    private static final double FORCE_NEWTONS = 50;
    private static final int CYCLES_OF_A_SPEED = 2;
    private static final int CYCLES_OF_A_STRIDE = 20;

    private static final List<Joint> LEGS =
            Stream.of(Leg.LEFT, Leg.RIGHT).flatMap(leg -> leg.joints().stream()).toList();

    /** Names and units of the values. Joint offsets are relative to {@link Stance#POSTURE}. */
    public static final List<Quantity> INPUTS = inputs();

    private int cycles;
    private final Balance balance = new Balance();
    private final Deque<Posture> postures = new ArrayDeque<>();
    private TorsoMotion torso = TorsoMotion.AT_REST;
    private FootPressure left = FootPressure.NONE;
    private FootPressure right = FootPressure.NONE;

    /** Creates the observation of a robot that stands upright. */
    public GaitObservation() {}

    private static List<Quantity> inputs() {
        List<Quantity> all = new ArrayList<>();
        add(all, "tilt", TILT_DEGREES, "degrees", "forward", "left");
        add(all, "gyro", GYRO_DEGREES_PER_SECOND, "degrees/s", "forward", "left", "up");
        add(all, "accelerometer", ACCELERATION, "m/s²", "forward", "left", "up");
        LEGS.forEach(joint -> add(all, "offset", OFFSET_DEGREES, "degrees", joint.name()));
        LEGS.forEach(joint -> add(all, "speed", SPEED_DEGREES_PER_SECOND, "degrees/s", joint.name()));
        for (String foot : List.of("leftFoot", "rightFoot")) {
            add(all, foot + ".point", POINT_METRES, "m", "forward", "left");
            add(all, foot + ".force", FORCE_NEWTONS, "N", "up");
        }
        LEGS.forEach(joint -> all.add(new Quantity("action." + joint, "1")));
        all.add(new Quantity("gait.sine", "1"));
        all.add(new Quantity("gait.cosine", "1"));
        return List.copyOf(all);
    }

    private static void add(List<Quantity> all, String name, double factor, String unit, String... parts) {
        for (String part : parts) {
            all.add(Quantity.scaled(name + "." + part, factor, unit));
        }
    }

    /**
     * Adds the readings of a cycle.
     *
     * @param joints the joint angles
     * @param torsoMotion readings of the gyroscope and the accelerometer
     * @param leftFoot pressure on the left sole
     * @param rightFoot pressure on the right sole
     */
    public void update(Posture joints, TorsoMotion torsoMotion, FootPressure leftFoot, FootPressure rightFoot) {
        cycles++;
        postures.addFirst(joints);
        if (postures.size() > CYCLES_OF_A_SPEED + 1) {
            postures.removeLast();
        }
        torso = torsoMotion;
        left = leftFoot;
        right = rightFoot;
        balance.update(torso);
    }

    /**
     * Returns the observation for the next action, after at least one update.
     *
     * @param action the last action, a value from -1 to 1 for each leg joint
     * @return the {@link #INPUTS}, as a new array
     */
    public double[] values(double... action) {
        double[] all = new double[INPUTS.size()];
        int next = put(all, 0, balance.pitchDegrees() / TILT_DEGREES, -balance.rollDegrees() / TILT_DEGREES);
        next = put(all, next, torso.gyro(), GYRO_DEGREES_PER_SECOND);
        next = put(all, next, torso.acceleration(), ACCELERATION);
        for (Joint joint : LEGS) {
            double degrees = postures.getFirst().degrees(joint);
            double offset = degrees - Stance.POSTURE.degrees(joint);
            double speed = (degrees - postures.getLast().degrees(joint)) / (CYCLES_OF_A_SPEED * Cycle.SECONDS);
            all[next + LEGS.size()] = speed / SPEED_DEGREES_PER_SECOND;
            all[next++] = offset / OFFSET_DEGREES;
        }
        next = put(all, next + LEGS.size(), left);
        next = put(all, next, right);
        next = put(all, next, action);
        double phase = 2 * Math.PI * cycles / CYCLES_OF_A_STRIDE;
        put(all, next, PortableMath.sin(phase), PortableMath.cos(phase));
        for (int i = 0; i < all.length; i++) {
            all[i] = Math.max(-MAX, Math.min(MAX, all[i]));
        }
        return all;
    }

    private static int put(double[] all, int index, FootPressure foot) {
        return put(
                all,
                index,
                foot.point().x() / POINT_METRES,
                foot.point().y() / POINT_METRES,
                foot.force().z() / FORCE_NEWTONS);
    }

    private static int put(double[] all, int index, Vector3 vector, double unit) {
        return put(all, index, vector.x() / unit, vector.y() / unit, vector.z() / unit);
    }

    private static int put(double[] all, int index, double... values) {
        System.arraycopy(values, 0, all, index, values.length);
        return index + values.length;
    }
}
