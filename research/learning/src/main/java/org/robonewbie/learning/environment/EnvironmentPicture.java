package org.robonewbie.learning.environment;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.util.List;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.BodyPoses;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.nao.model.Link;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.trial.WorldState;

/** Drawing data of an environment: a box for each colliding link, and the ball. */
final class EnvironmentPicture {

    private EnvironmentPicture() {}

    /** The moment as JSON: for each robot its boxes, each with its {@linkplain BodyPoses#corners eight corners} in metres, and the centre of the ball. */
    static JsonObject of(WorldState now) {
        JsonArray robots = new JsonArray();
        now.robots().forEach(robot -> robots.add(boxes(robot)));
        JsonObject picture = new JsonObject();
        picture.add("robots", robots);
        picture.add("ball", point(now.ball()));
        return picture;
    }

    private static JsonArray boxes(BodyState robot) {
        List<Link> links = NaoModel.of(robot.type()).links();
        BodyPoses limbs = robot.limbs();
        JsonArray boxes = new JsonArray();
        for (int i = 0; i < links.size(); i++) {
            if (links.get(i).collides()) {
                JsonArray box = new JsonArray();
                limbs.corners(i).forEach(corner -> box.add(point(corner)));
                boxes.add(box);
            }
        }
        return boxes;
    }

    private static JsonArray point(Vector3 place) {
        JsonArray point = new JsonArray();
        point.add(place.x());
        point.add(place.y());
        point.add(place.z());
        return point;
    }
}
