package org.robonewbie.studio;

import com.google.gson.Gson;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.stream.IntStream;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.kinematics.Rotation;
import org.robonewbie.nao.kinematics.SimSparkFrame;
import org.robonewbie.nao.model.Link;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.Posture;
import org.robonewbie.simulator.physics.Collider;
import org.robonewbie.simulator.physics.ode.OdeCollisions;

/** The colliding limbs of a robot in a posture and their penetration depths, as the simulator computes them. */
final class TouchingLimbs {

    private static final int POSTURES = 300;

    private final List<Link> links = NaoModel.of(RobotType.TYPE_0).links();
    private final OdeCollisions collisions = new OdeCollisions();
    private final List<OdeCollisions.Geometry> shapes = new ArrayList<>();

    private TouchingLimbs() {
        for (int i = 0; i < links.size(); i++) {
            int link = i;
            Collider collider = () -> link;
            shapes.add(collisions.scenery().add(links.get(i).shape(), collider, true));
        }
    }

    /** Writes random postures, each with the colliding pairs of links and the depth in metres. */
    static void write(Path file) throws IOException {
        TouchingLimbs limbs = new TouchingLimbs();
        Random random = new Random(12);
        List<Map<String, Object>> postures = new ArrayList<>();
        for (int i = 0; i < POSTURES; i++) {
            double[] degrees = Arrays.stream(Joint.values())
                    .mapToDouble(joint ->
                            joint.minDegrees() + random.nextDouble() * (joint.maxDegrees() - joint.minDegrees()))
                    .toArray();
            postures.add(Map.of("degrees", degrees, "pairs", limbs.pairs(Posture.of(degrees))));
        }
        Files.writeString(file, new Gson().toJson(postures));
    }

    private List<double[]> pairs(Posture posture) {
        List<Pose> poses =
                BodyState.of(RobotType.TYPE_0, Pose.ORIGIN, posture).limbs().links();
        for (int i = 0; i < shapes.size(); i++) {
            Pose pose = poses.get(i);
            Vector3 place = pose.position();
            Rotation turn = SimSparkFrame.linkFromBody(pose).rotation();
            shapes.get(i).place(new double[] {place.x(), place.y(), place.z()}, matrix(turn));
        }
        List<double[]> pairs = new ArrayList<>();
        collisions.find((first, second, points, count) -> {
            double depth = IntStream.range(0, count)
                    .mapToDouble(point -> points[point * OdeCollisions.DOUBLES_PER_POINT + 6])
                    .max()
                    .orElse(0);
            pairs.add(new double[] {(int) first.owner(), (int) second.owner(), depth});
        });
        return pairs;
    }

    private static double[] matrix(Rotation turn) {
        Vector3 x = turn.apply(new Vector3(1, 0, 0));
        Vector3 y = turn.apply(new Vector3(0, 1, 0));
        Vector3 z = turn.apply(new Vector3(0, 0, 1));
        return new double[] {x.x(), y.x(), z.x(), x.y(), y.y(), z.y(), x.z(), y.z(), z.z()};
    }
}
