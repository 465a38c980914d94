package org.robonewbie.learning.environment;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.robonewbie.agent.perception.FootPressure;
import org.robonewbie.agent.perception.TorsoMotion;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.SimSparkFrame;
import org.robonewbie.nao.motion.Posture;
import org.robonewbie.protocol.perceptor.FootForce;
import org.robonewbie.protocol.perceptor.PerceptorMessageWriter;
import org.robonewbie.protocol.perceptor.PolarPosition;
import org.robonewbie.trial.SensorReadings;

/**
 * Converts a robot's sensor readings to an observation vector, with the resolution of perceptor messages (hundredths).
 * Axes are those of an agent: forward, left, up. The last camera image is used until the next one arrives, 60 ms later.
 *
 * <pre>{@code
 * Perception perception = new Perception(false);
 * trial.step();
 * double[] row = perception.observe(trial.readings(0));
 * }</pre>
 */
public final class Perception {

    private static final double FAR_METRES = 40;
    private static final double STRONG_NEWTONS = 1000;
    private static final int NUMBERS_PER_FOOT = 6;
    private static final int NUMBERS_OF_THE_BALL = 4;
    private static final int FIRST_OF_THE_FEET = Joint.COUNT + 6;
    private static final Joint[] JOINTS = Joint.values();

    private static final List<ObservedQuantity> WITHOUT_CAMERA = quantities(false);
    private static final List<ObservedQuantity> WITH_CAMERA = quantities(true);

    private final double[] ball;

    /**
     * Creates a converter that has not received any readings yet.
     *
     * @param camera whether to observe the ball with the camera
     */
    public Perception(boolean camera) {
        ball = new double[camera ? NUMBERS_OF_THE_BALL : 0];
    }

    /** {@return the names, units and ranges of an observation's components; unmodifiable} */
    public List<ObservedQuantity> quantities() {
        return ball.length > 0 ? WITH_CAMERA : WITHOUT_CAMERA;
    }

    private static List<ObservedQuantity> quantities(boolean camera) {
        List<ObservedQuantity> all = new ArrayList<>();
        for (Joint joint : JOINTS) {
            all.add(new ObservedQuantity("joint." + joint, "degrees", joint.minDegrees(), joint.maxDegrees()));
        }
        all.addAll(ObservedQuantity.vector("gyro", "degrees/s", 2000));
        all.addAll(ObservedQuantity.vector("accelerometer", "m/s²", 500));
        for (String foot : List.of("leftFoot", "rightFoot")) {
            all.addAll(ObservedQuantity.vector(foot + ".point", "m", 0.2));
            all.addAll(ObservedQuantity.vector(foot + ".force", "N", STRONG_NEWTONS));
        }
        if (camera) {
            all.add(new ObservedQuantity("ball.inSight", "1 or 0", 0, 1));
            all.add(new ObservedQuantity("ball.distance", "m", 0, FAR_METRES));
            all.add(new ObservedQuantity("ball.horizontal", "degrees", -180, 180));
            all.add(new ObservedQuantity("ball.vertical", "degrees", -90, 90));
        }
        return List.copyOf(all);
    }

    /**
     * Converts the readings of a cycle. Call once per cycle.
     *
     * @param readings the robot's readings
     * @return a new array with a value for each of the {@link #quantities}
     */
    public double[] observe(SensorReadings readings) {
        double[] row = new double[quantities().size()];
        for (Joint joint : JOINTS) {
            row[joint.ordinal()] = readings.degrees(joint);
        }
        put(row, Joint.COUNT, readings.gyro());
        put(row, Joint.COUNT + 3, readings.acceleration());
        putFoot(row, FIRST_OF_THE_FEET, readings.feet().left());
        putFoot(row, FIRST_OF_THE_FEET + NUMBERS_PER_FOOT, readings.feet().right());
        if (ball.length > 0) {
            readings.picture().ifPresent(picture -> look(picture.ball()));
            System.arraycopy(ball, 0, row, row.length - ball.length, ball.length);
        }
        return row;
    }

    private void look(Optional<PolarPosition> inSight) {
        ball[0] = inSight.isPresent() ? 1 : 0;
        inSight.ifPresent(seen -> {
            ball[1] = PerceptorMessageWriter.rounded(seen.distanceMetres());
            ball[2] = PerceptorMessageWriter.rounded(seen.horizontalDegrees());
            ball[3] = PerceptorMessageWriter.rounded(seen.verticalDegrees());
        });
    }

    static Posture posture(double... row) {
        return Posture.of(Arrays.copyOf(row, Joint.COUNT));
    }

    static TorsoMotion torso(double... row) {
        return new TorsoMotion(vector(row, Joint.COUNT), vector(row, Joint.COUNT + 3));
    }

    static FootPressure leftFoot(double... row) {
        return foot(row, FIRST_OF_THE_FEET);
    }

    static FootPressure rightFoot(double... row) {
        return foot(row, FIRST_OF_THE_FEET + NUMBERS_PER_FOOT);
    }

    private static FootPressure foot(double[] row, int index) {
        return new FootPressure(vector(row, index), vector(row, index + 3));
    }

    private static Vector3 vector(double[] row, int index) {
        return new Vector3(row[index], row[index + 1], row[index + 2]);
    }

    private static void putFoot(double[] row, int index, Optional<FootForce> foot) {
        foot.ifPresent(contact -> {
            put(row, index, contact.point());
            put(row, index + 3, contact.force());
        });
    }

    private static void put(double[] row, int index, Vector3 reading) {
        Vector3 body = SimSparkFrame.toBody(reading);
        row[index] = body.x();
        row[index + 1] = body.y();
        row[index + 2] = body.z();
    }
}
