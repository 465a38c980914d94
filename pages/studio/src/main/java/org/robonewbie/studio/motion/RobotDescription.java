package org.robonewbie.studio.motion;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.model.Link;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.model.Shape;
import org.robonewbie.nao.motion.JointSpace;
import org.robonewbie.nao.motion.Mirror;
import org.robonewbie.robot.NaoRobot;
import org.robonewbie.robot.RobotModel;
import org.robonewbie.robot.RobotModels;
import org.robonewbie.simulator.json.RobotModelJson;
import org.robonewbie.studio.file.RefusedException;

/** Description of the robot for the motion editor: joints in the order of motion files, masses, and collision shapes. */
public final class RobotDescription {

    private RobotDescription() {}

    /**
     * Writes the description of a robot other than the NAO that this framework ships.
     *
     * @param name name of its model
     * @return one JSON object
     * @throws RefusedException if there is no such model
     */
    public static String write(String name) {
        return others().filter(model -> model.name().equals(name))
                .findFirst()
                .map(RobotDescription::write)
                .orElseThrow(() -> new RefusedException(
                        404, "Its robot is \"" + name + "\", but the studio knows " + known() + " only."));
    }

    /**
     * Writes the description of a robot other than the NAO: its joints and shapes. Partners of joints and masses are left out.
     *
     * @param model the robot
     * @return one JSON object
     */
    public static String write(RobotModel model) {
        JsonArray joints = new JsonArray();
        for (JointSpace.Limits joint : model.jointSpace().joints()) {
            joints.add(joint(joint));
        }
        JsonObject json = new JsonObject();
        json.add("joints", joints);
        json.add("model", RobotModelJson.write(model));
        return json.toString();
    }

    private static Stream<RobotModel> others() {
        return RobotModels.all().stream().filter(model -> !NaoRobot.isNao(model));
    }

    private static String known() {
        return Stream.concat(Stream.of(JointSpace.NAO.robot()), others().map(RobotModel::name))
                .collect(Collectors.joining(", "));
    }

    /**
     * Writes the description of the NAO.
     *
     * @param model the robot's limbs and hinges as JSON
     * @return one JSON object
     */
    public static String write(JsonObject model) {
        JsonArray joints = new JsonArray();
        for (Joint joint : Joint.values()) {
            JsonObject each = joint(JointSpace.NAO.joints().get(joint.ordinal()));
            each.addProperty("partner", Mirror.partner(joint).ordinal());
            each.addProperty("mirrorSign", Mirror.mirroredDegrees(joint, 1));
            joints.add(each);
        }
        JsonArray links = new JsonArray();
        for (Link link : NaoModel.of(RobotType.TYPE_0).links()) {
            JsonObject json = new JsonObject();
            json.addProperty("massKg", link.massKg());
            json.addProperty("solid", link.collides());
            addShape(json, link.shape());
            links.add(json);
        }
        JsonObject json = new JsonObject();
        json.add("joints", joints);
        json.add("model", model);
        json.add("links", links);
        return json.toString();
    }

    /** Adds the collision shape if it is not a box. */
    private static void addShape(JsonObject json, Shape shape) {
        if (shape instanceof Shape.Sphere ball) {
            json.addProperty("radius", ball.radius());
        } else if (shape instanceof Shape.Capsule capsule) {
            json.addProperty("radius", capsule.radius());
            json.addProperty("length", capsule.length());
        }
    }

    /** Describes a joint. Its range is rounded inward to hundredths of a degree, which can be read and typed. */
    private static JsonObject joint(JointSpace.Limits joint) {
        JsonObject json = new JsonObject();
        json.addProperty("name", joint.name());
        json.addProperty("minDegrees", Math.ceil(joint.minDegrees() * 100) / 100);
        json.addProperty("maxDegrees", Math.floor(joint.maxDegrees() * 100) / 100);
        if (Double.isFinite(joint.maxDegreesPerSecond())) {
            json.addProperty("maxDegreesPerSecond", joint.maxDegreesPerSecond());
        }
        return json;
    }
}
