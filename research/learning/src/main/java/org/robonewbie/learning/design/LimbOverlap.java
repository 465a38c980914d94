package org.robonewbie.learning.design;

import java.util.List;
import java.util.function.Function;
import java.util.stream.Stream;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.kinematics.SimSparkFrame;
import org.robonewbie.nao.model.Link;
import org.robonewbie.nao.model.NaoModel;

/**
 * How deep limbs of a robot are within each other. In SimSpark they pass through each other, and a referee forgives 4 cm; a real robot cannot
 * do that, so a search should not get used to it.
 */
final class LimbOverlap {

    private static final List<String> LEFT = List.of("lthigh", "lshank", "lfoot");
    private static final List<String> RIGHT = List.of("rthigh", "rshank", "rfoot");
    private static final List<String> ARMS = List.of("llowerarm", "rlowerarm");
    private static final double[] STEPS = {-1, -0.5, 0, 0.5, 1};

    private final NaoModel model;

    LimbOverlap(NaoModel model) {
        this.model = model;
    }

    /** The links of which it has to be known where they are. */
    static List<String> links() {
        return Stream.of(LEFT, RIGHT, ARMS).flatMap(List::stream).toList();
    }

    /**
     * The depths of all pairs of limbs that overlap, added up, in metres: left with right leg, and each lower arm with its thigh.
     *
     * @param poses tells where each of {@link #links} is
     */
    double metres(Function<String, Pose> poses) {
        double sum = depth(poses, "llowerarm", "lthigh") + depth(poses, "rlowerarm", "rthigh");
        for (String left : LEFT) {
            for (String right : RIGHT) {
                sum += depth(poses, left, right);
            }
        }
        return sum;
    }

    private double depth(Function<String, Pose> poses, String one, String other) {
        Vector3 half = half(one);
        Vector3 otherHalf = half(other);
        Pose pose = poses.apply(one);
        Pose otherPose = poses.apply(other);
        if (pose.position().distanceTo(otherPose.position()) > half.length() + otherHalf.length()) {
            return 0;
        }
        return Math.max(depth(pose, half, otherPose, otherHalf), depth(otherPose, otherHalf, pose, half));
    }

    /** How deep the deepest point of one box lies within another one. */
    private static double depth(Pose pose, Vector3 half, Pose otherPose, Vector3 otherHalf) {
        Pose seen = otherPose.inverse().times(pose);
        double deepest = 0;
        for (double x : STEPS) {
            for (double y : STEPS) {
                for (double z : STEPS) {
                    Vector3 point = seen.transform(new Vector3(x * half.x(), y * half.y(), z * half.z()));
                    deepest = Math.max(deepest, depth(point, otherHalf));
                }
            }
        }
        return deepest;
    }

    private static double depth(Vector3 point, Vector3 half) {
        return Math.min(
                half.x() - Math.abs(point.x()),
                Math.min(half.y() - Math.abs(point.y()), half.z() - Math.abs(point.z())));
    }

    private Vector3 half(String link) {
        return half(model.links().get(model.linkIndex(link)));
    }

    /** Half the size of a link along the axes of the body frame, in metres. */
    static Vector3 half(Link link) {
        Vector3 size = SimSparkFrame.toBody(link.shape().size());
        return new Vector3(Math.abs(size.x()), Math.abs(size.y()), Math.abs(size.z())).times(0.5);
    }
}
