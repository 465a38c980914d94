package org.robonewbie.agent.walk;

import java.util.List;
import java.util.stream.Stream;
import org.robonewbie.agent.perception.FootPressure;
import org.robonewbie.agent.policy.InferenceSession;
import org.robonewbie.agent.policy.Network;
import org.robonewbie.agent.policy.Quantity;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.kinematics.Leg;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.nao.motion.Mirror;
import org.robonewbie.nao.motion.Posture;

/**
 * A learned reflex: a network that moves the joints of both legs by up to {@link #RANGE_DEGREES} from the engine's
 * posture. It distinguishes the swing leg from the support leg, not left from right: while the right leg is the swing
 * leg, inputs and outputs are mirrored.
 *
 * @param network maps {@link #INPUTS} to {@link #OUTPUTS}
 */
public record ResidualPolicy(Network network) implements WalkReflex {

    /** Joint offset, in degrees, that an output of 1 causes. */
    public static final double RANGE_DEGREES = 20;

    private static final double TILT = 10;
    private static final double RATE = 100;
    private static final double ASIDE = 0.3;
    private static final double FORCE = 50;
    private static final double SOLE = 0.05;

    /** Inputs are clipped to this multiple of their unit, for example during shocks. */
    public static final double MAX_INPUT = 3;

    /** Inputs of the network: phase of the step, tilt, velocities, and forces on the soles. */
    public static final List<Quantity> INPUTS = List.of(
            new Quantity("step.sine-of-2-pi-phase", "1"),
            new Quantity("step.cosine-of-2-pi-phase", "1"),
            new Quantity("step.cosine-of-pi-phase", "1"),
            new Quantity("step.amplitude", "1"),
            new Quantity("pitch.error", "10 degrees"),
            new Quantity("pitch.rate", "100 degrees/s"),
            new Quantity("roll-to-support.error", "10 degrees"),
            new Quantity("roll-to-support.rate", "100 degrees/s"),
            new Quantity("turn-to-swing.rate", "100 degrees/s"),
            new Quantity("wanted.forward", "m/s"),
            new Quantity("wanted.to-swing", "0.3 m/s"),
            new Quantity("wanted.turn-to-swing", "100 degrees/s"),
            new Quantity("planned.forward", "m/s"),
            new Quantity("planned.to-swing", "0.3 m/s"),
            new Quantity("planned.turn-to-swing", "100 degrees/s"),
            new Quantity("swing-foot.force.up", "50 N"),
            new Quantity("support-foot.force.up", "50 N"),
            new Quantity("support-foot.point.forward", "0.05 m"),
            new Quantity("support-foot.point.to-swing", "0.05 m"));

    /** Outputs of the network: offset of each leg joint, mirrored while the right leg is the swing leg. */
    public static final List<Quantity> OUTPUTS = Stream.of("swing", "support")
            .flatMap(leg -> Leg.LEFT.joints().stream()
                    .map(joint -> joint.name().replace("LEFT", leg))
                    .map(name -> new Quantity(name, "20 degrees")))
            .toList();

    private static final int JOINTS_OF_A_LEG = OUTPUTS.size() / 2;

    @Override
    public Posture corrected(Posture planned, WalkMoment moment) {
        return corrected(planned, moment, network.apply(inputs(moment)));
    }

    @Override
    public WalkReflex forEngine() {
        InferenceSession session = network.session();
        return (planned, moment) -> corrected(planned, moment, session.apply(inputs(moment)));
    }

    /**
     * Adds the outputs of a network to a posture.
     *
     * @param planned the engine's posture
     * @param moment state of the walk in this cycle
     * @param outputs the {@link #OUTPUTS}, each from -1 to 1
     * @return the corrected posture
     */
    public static Posture corrected(Posture planned, WalkMoment moment, double... outputs) {
        double[] degrees = planned.toArray();
        double scale = RANGE_DEGREES * moment.amplitude();
        move(degrees, moment.swing(), moment.swing(), scale, outputs, 0);
        move(degrees, moment.swing().other(), moment.swing(), scale, outputs, JOINTS_OF_A_LEG);
        return Posture.of(degrees);
    }

    /** Moves the joints of one leg, mirrored unless the left leg is the swing leg. */
    private static void move(double[] degrees, Leg leg, Leg swing, double scale, double[] outputs, int first) {
        for (int i = 0; i < JOINTS_OF_A_LEG; i++) {
            Joint joint = leg.joints().get(i);
            double way = scale * outputs[first + i];
            double moved = degrees[joint.ordinal()] + (swing == Leg.LEFT ? way : Mirror.mirroredDegrees(joint, way));
            degrees[joint.ordinal()] = joint.clampDegrees(moved);
        }
    }

    /**
     * Computes the inputs of the network.
     *
     * @param moment state of the walk in this cycle
     * @return the {@link #INPUTS}, as a new array
     */
    public static double[] inputs(WalkMoment moment) {
        double side = moment.swing() == Leg.LEFT ? 1 : -1;
        FootPressure swing = moment.swing() == Leg.LEFT ? moment.left() : moment.right();
        FootPressure support = moment.swing() == Leg.LEFT ? moment.right() : moment.left();
        double angle = Math.PI * moment.phase();
        return limited(
                PortableMath.sin(2 * angle),
                PortableMath.cos(2 * angle),
                PortableMath.cos(angle),
                moment.amplitude(),
                moment.pitchError() / TILT,
                moment.pitchRate() / RATE,
                side * moment.rollError() / TILT,
                side * moment.rollRate() / RATE,
                side * moment.turnRate() / RATE,
                moment.wanted().forward(),
                side * moment.wanted().left() / ASIDE,
                side * moment.wanted().turn() / RATE,
                moment.velocity().forward(),
                side * moment.velocity().left() / ASIDE,
                side * moment.velocity().turn() / RATE,
                swing.force().z() / FORCE,
                support.force().z() / FORCE,
                support.point().x() / SOLE,
                side * support.point().y() / SOLE);
    }

    private static double[] limited(double... values) {
        for (int i = 0; i < values.length; i++) {
            values[i] = Math.max(-MAX_INPUT, Math.min(MAX_INPUT, values[i]));
        }
        return values;
    }
}
