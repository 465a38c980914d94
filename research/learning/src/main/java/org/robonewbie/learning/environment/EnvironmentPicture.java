package org.robonewbie.learning.environment;

import com.google.gson.Gson;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.BodyPoses;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.nao.model.Link;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.trial.WorldState;

/** Drawing data for an environment: a box for each colliding link, and the ball. */
final class EnvironmentPicture {

    private EnvironmentPicture() {}

    /** Returns JSON with the {@linkplain BodyPoses#corners corners} of each robot's boxes and the centre of the ball, in metres. */
    static String of(WorldState now) {
        return new Gson()
                .toJson(Map.of(
                        "robots",
                        now.robots().stream().map(EnvironmentPicture::boxes).toList(),
                        "ball",
                        point(now.ball())));
    }

    private static List<List<double[]>> boxes(BodyState robot) {
        List<Link> links = NaoModel.of(robot.type()).links();
        BodyPoses limbs = robot.limbs();
        return IntStream.range(0, links.size())
                .filter(i -> links.get(i).collides())
                .mapToObj(i ->
                        limbs.corners(i).stream().map(EnvironmentPicture::point).toList())
                .toList();
    }

    private static double[] point(Vector3 point) {
        return new double[] {point.x(), point.y(), point.z()};
    }
}
