package org.robonewbie.agent.walk;

import java.util.List;
import java.util.stream.Stream;
import org.robonewbie.agent.perception.FootPressure;
import org.robonewbie.agent.policy.Network;
import org.robonewbie.agent.policy.Quantity;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.kinematics.Leg;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.nao.motion.Mirror;
import org.robonewbie.nao.motion.Posture;

/**
 * A reflex that was learned: a network that moves the joints of both legs by up to {@link #RANGE_DEGREES} from where the engine
 * wants them. It knows the swing leg and the support leg, not left and right: while the right leg swings, all that it feels and
 * does is mirrored.
 *
 * @param network takes the {@link #INPUTS} and gives the {@link #OUTPUTS}
 */
public record ResidualPolicy(Network network) implements WalkReflex {

    /** What an output of 1 means. */
    public static final double RANGE_DEGREES = 20;

    private static final double TILT = 10;
    private static final double RATE = 100;
    private static final double ASIDE = 0.3;
    private static final double FORCE = 50;
    private static final double SOLE = 0.05;

    /** Knocks are cut off at this multiple of a quantity's unit, so that no input is larger. */
    public static final double MAX_INPUT = 3;

    /** What the network takes: where in its step the robot is, how it tilts, and what its soles feel. */
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

    /** What the network gives: by how much each joint of a leg is moved, mirrored while the right leg swings. */
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

    /**
     * Moves the joints as a network wants it.
     *
     * @param planned the engine's posture
     * @param moment where in its step the robot is
     * @param outputs the {@link #OUTPUTS}, each from -1 to 1
     * @return where the joints go instead
     */
    public static Posture corrected(Posture planned, WalkMoment moment, double... outputs) {
        double[] degrees = planned.toArray();
        double scale = RANGE_DEGREES * moment.amplitude();
        move(degrees, moment.swing(), moment.swing(), scale, outputs, 0);
        move(degrees, moment.swing().other(), moment.swing(), scale, outputs, JOINTS_OF_A_LEG);
        return Posture.of(degrees);
    }

    /** Moves the joints of one leg; all is mirrored unless the left leg swings. */
    private static void move(double[] degrees, Leg leg, Leg swing, double scale, double[] outputs, int first) {
        for (int i = 0; i < JOINTS_OF_A_LEG; i++) {
            Joint joint = leg.joints().get(i);
            double way = scale * outputs[first + i];
            double moved = degrees[joint.ordinal()] + (swing == Leg.LEFT ? way : Mirror.mirroredDegrees(joint, way));
            degrees[joint.ordinal()] = joint.clampDegrees(moved);
        }
    }

    /**
     * Calculates what a network takes.
     *
     * @param moment where in its step the robot is and what it feels
     * @return the {@link #INPUTS}; a new array
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
