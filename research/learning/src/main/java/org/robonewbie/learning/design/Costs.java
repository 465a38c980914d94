package org.robonewbie.learning.design;

import java.util.Arrays;
import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.robonewbie.learning.rehearsal.Poise;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.kinematics.InverseKinematics;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.Keyframe;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.Posture;

/** What several designs have in common. */
public final class Costs {

    private Costs() {}

    /** Likes a torso that stays upright and calm, and motors that are not asked for all they can do. */
    static double roughness(Poise poise) {
        return 2 * poise.meanTilt() + 0.01 * poise.meanRocking() + 0.3 * poise.meanJointsAtLimit();
    }

    /** Keeps a search near its first guess: a tenth for each unit that a coordinate is beyond a limit. */
    static double beyond(double[] coordinates, double limit) {
        return 0.1 * excess(coordinates, limit);
    }

    /**
     * Adds up by how much coordinates are beyond a limit.
     *
     * @param coordinates the coordinates
     * @param limit the limit, to either side
     * @return 0 if all are within it
     */
    public static double excess(double[] coordinates, double limit) {
        return Arrays.stream(coordinates)
                .map(x -> Math.max(0, Math.abs(x) - limit))
                .sum();
    }

    /**
     * Adds up by how much a motion that is played again and again asks for more than the motors can do.
     *
     * @param motion the motion
     * @return degrees, 0 if each joint has time enough
     */
    public static double degreesBeyondMotors(Motion motion) {
        double sum = 0;
        List<Keyframe> keyframes = motion.keyframes();
        Posture before = keyframes.get(keyframes.size() - 1).posture();
        for (Keyframe keyframe : keyframes) {
            double seconds = keyframe.durationMillis() / 1000.0;
            for (Joint joint : Joint.values()) {
                double way = Math.abs(keyframe.posture().degrees(joint) - before.degrees(joint));
                sum += Math.max(0, way - joint.maxDegreesPerSecond() * seconds);
            }
            before = keyframe.posture();
        }
        return sum;
    }

    /** Tries the better half of the candidates twice and takes the mean; the others rank behind it. */
    static double[] betterHalfTwice(
            List<double[]> candidates, ToDoubleFunction<double[]> first, ToDoubleFunction<double[]> second) {
        double[] once = candidates.stream().mapToDouble(first).toArray();
        double median = DoubleStream.of(once).sorted().toArray()[once.length / 2];
        return IntStream.range(0, once.length)
                .mapToDouble(
                        i -> once[i] < median ? (once[i] + second.applyAsDouble(candidates.get(i))) / 2 : 100 + once[i])
                .toArray();
    }

    /** A posture within the joints' ranges with angles in tenths of a degree. */
    static Posture rounded(Posture posture) {
        double[] degrees = posture.clamped().toArray();
        for (int i = 0; i < degrees.length; i++) {
            degrees[i] = Math.round(degrees[i] * 10) / 10.0;
        }
        return Posture.of(degrees);
    }

    /** Kinematics for one calculation; trials of several threads cannot share one. */
    static InverseKinematics kinematics() {
        return new InverseKinematics(RobotType.TYPE_0);
    }
}
