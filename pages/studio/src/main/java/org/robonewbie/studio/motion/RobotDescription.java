package org.robonewbie.studio.motion;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.model.Link;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.model.Shape;
import org.robonewbie.nao.motion.Mirror;

/** Description of the robot for the motion editor: joints in the order of motion files, masses, and collision shapes. */
public final class RobotDescription {

    private RobotDescription() {}

    /**
     * Writes the description.
     *
     * @param model the robot's limbs and hinges as JSON
     * @return one JSON object
     */
    public static String write(JsonObject model) {
        JsonArray joints = new JsonArray();
        for (Joint joint : Joint.values()) {
            joints.add(joint(joint));
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

    private static JsonObject joint(Joint joint) {
        JsonObject json = new JsonObject();
        json.addProperty("name", joint.name());
        json.addProperty("minDegrees", joint.minDegrees());
        json.addProperty("maxDegrees", joint.maxDegrees());
        json.addProperty("maxDegreesPerSecond", joint.maxDegreesPerSecond());
        json.addProperty("partner", Mirror.partner(joint).ordinal());
        json.addProperty("mirrorSign", Mirror.mirroredDegrees(joint, 1));
        return json;
    }
}
