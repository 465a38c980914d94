package org.robonewbie.simulator.json;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParseException;
import com.google.gson.JsonParser;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.kinematics.Rotation;
import org.robonewbie.nao.kinematics.SimSparkFrame;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.nao.model.Shape;
import org.robonewbie.robot.Motor;
import org.robonewbie.robot.PlacedShape;
import org.robonewbie.robot.RobotBody;
import org.robonewbie.robot.RobotJoint;
import org.robonewbie.robot.RobotModel;

/**
 * JSON form of a {@link RobotModel}, which pages draw and recordings contain. It is the form of the NAO's models on pages, with shapes:
 *
 * <pre>
 * name, stanceHeight
 * links    name, position, size, shapes: kind (box, sphere or capsule), size, position, rotation
 * hinges   joint, sensor, effector, parent, child, anchor, axis, minDegrees, maxDegrees, maxSpeed or maxTorque, stanceDegrees
 * </pre>
 *
 * <p>All links have the axes of SimSpark's torso (x right, y forward, z up) while every joint is at 0°; positions, anchors and axes are
 * those of that posture, relative to the torso. Masses are left out.
 */
public final class RobotModelJson {

    private static final int MAX_LINKS = 1000;
    private static final double MAX_NUMBER = 1e6;
    private static final double ROUNDING = 1e7;

    private RobotModelJson() {}

    /**
     * Writes a model.
     *
     * @param model the model
     * @return the JSON form
     */
    public static JsonObject write(RobotModel model) {
        List<Pose> poses = model.bodyPoses(new double[model.joints().size()]);
        JsonArray links = new JsonArray();
        for (int i = 0; i < poses.size(); i++) {
            links.add(link(model.bodies().get(i), poses.get(i)));
        }
        return Json.object(
                "name", model.name(),
                "stanceHeight", model.stanceHeight(),
                "links", links,
                "hinges", Json.array(model.joints().stream().map(joint -> hinge(model, joint, poses))));
    }

    private static JsonObject link(RobotBody body, Pose pose) {
        Vector3 reach = Vector3.ZERO;
        JsonArray shapes = new JsonArray();
        for (PlacedShape placed : body.shapes()) {
            Pose turned = SimSparkFrame.fromBody(new Pose(
                    pose.rotation().apply(placed.pose().position()),
                    pose.rotation().times(placed.pose().rotation())));
            Shape shape = placed.shape();
            reach = farther(reach, turned, size(shape));
            shapes.add(Json.object(
                    "kind", kind(shape),
                    "size", numbers(size(shape)),
                    "position", numbers(turned.position()),
                    "rotation", numbers(turned.rotation())));
        }
        return Json.object(
                "name", body.name(),
                "position", numbers(SimSparkFrame.fromBody(pose.position())),
                "size", numbers(reach.times(2)),
                "shapes", shapes);
    }

    /** Returns the half edges of a box around the link's origin that contains one more shape. */
    private static Vector3 farther(Vector3 reach, Pose pose, Vector3 size) {
        Vector3 x = absolute(pose.rotation().apply(new Vector3(size.x() / 2, 0, 0)));
        Vector3 y = absolute(pose.rotation().apply(new Vector3(0, size.y() / 2, 0)));
        Vector3 z = absolute(pose.rotation().apply(new Vector3(0, 0, size.z() / 2)));
        Vector3 far = absolute(pose.position()).plus(x).plus(y).plus(z);
        return new Vector3(Math.max(reach.x(), far.x()), Math.max(reach.y(), far.y()), Math.max(reach.z(), far.z()));
    }

    private static Vector3 absolute(Vector3 vector) {
        return new Vector3(Math.abs(vector.x()), Math.abs(vector.y()), Math.abs(vector.z()));
    }

    private static String kind(Shape shape) {
        return shape instanceof Shape.Box ? "box" : shape instanceof Shape.Sphere ? "sphere" : "capsule";
    }

    /** Returns the size of a shape along SimSpark's axes: x and y of a box are exchanged. */
    private static Vector3 size(Shape shape) {
        Vector3 size = shape.size();
        return new Vector3(size.y(), size.x(), size.z());
    }

    private static JsonObject hinge(RobotModel model, RobotJoint joint, List<Pose> poses) {
        Pose pose = poses.get(joint.body());
        JsonObject json = Json.object(
                "joint",
                joint.name(),
                "sensor",
                joint.perceptorName(),
                "effector",
                joint.effectorName(),
                "parent",
                model.bodies().get(joint.body()).parent(),
                "child",
                joint.body(),
                "anchor",
                numbers(SimSparkFrame.fromBody(pose.transform(joint.anchor()))),
                "axis",
                numbers(SimSparkFrame.fromBody(pose.rotation().apply(joint.axis()))),
                "minDegrees",
                joint.minDegrees(),
                "maxDegrees",
                joint.maxDegrees(),
                "stanceDegrees",
                joint.stanceDegrees());
        if (joint.motor() instanceof Motor.Torque torque) {
            json.addProperty("maxTorque", torque.maxNewtonMetres());
            json.addProperty("stiffness", torque.stiffness());
            json.addProperty("damping", torque.damping());
        } else if (joint.motor() instanceof Motor.Speed speed) {
            json.addProperty("maxSpeed", speed.maxDegreesPerSecond());
        }
        return json;
    }

    private static List<Double> numbers(Vector3 vector) {
        return List.of(rounded(vector.x()), rounded(vector.y()), rounded(vector.z()));
    }

    private static List<Double> numbers(Rotation rotation) {
        return List.of(rounded(rotation.w()), rounded(rotation.x()), rounded(rotation.y()), rounded(rotation.z()));
    }

    private static double rounded(double value) {
        return PortableMath.round(value * ROUNDING) / ROUNDING;
    }

    /**
     * Reads a model.
     *
     * @param text the JSON form
     * @return the model
     * @throws IllegalArgumentException if the text is not a model; the message says why
     */
    public static RobotModel read(String text) {
        try {
            return new Reader(JsonParser.parseString(text)).model();
        } catch (JsonParseException notJson) {
            throw new IllegalArgumentException("The model is not JSON.", notJson);
        }
    }

    /** Reads one model. Each method throws an {@link IllegalArgumentException} for what is not of its kind. */
    private static final class Reader {

        private final JsonElement json;
        private final JsonArray links;
        private final JsonArray hinges;

        Reader(JsonElement json) {
            this.json = json;
            links = array(json, "links");
            hinges = array(json, "hinges");
        }

        RobotModel model() {
            if (links.size() > MAX_LINKS || hinges.size() >= links.size()) {
                throw new IllegalArgumentException("The model has " + links.size() + " links and " + hinges.size()
                        + " hinges; each link but the first has one hinge, and at most " + MAX_LINKS
                        + " links are accepted.");
            }
            List<Integer> parents = parents();
            List<RobotBody> bodies = new ArrayList<>();
            for (int i = 0; i < links.size(); i++) {
                bodies.add(body(links.get(i), parents.get(i)));
            }
            List<RobotJoint> joints = new ArrayList<>();
            for (JsonElement hinge : hinges) {
                joints.add(joint(hinge, joints.size()));
            }
            return new RobotModel(text(json, "name"), bodies, joints, number(json, "stanceHeight"));
        }

        private List<Integer> parents() {
            List<Integer> parents = new ArrayList<>(Collections.nCopies(links.size(), RobotBody.NO_PARENT));
            for (JsonElement hinge : hinges) {
                parents.set(link(hinge, "child"), link(hinge, "parent"));
            }
            return parents;
        }

        private RobotBody body(JsonElement link, int parent) {
            Vector3 origin = parent == RobotBody.NO_PARENT ? Vector3.ZERO : position(parent);
            List<PlacedShape> shapes = new ArrayList<>();
            for (JsonElement shape : array(link, "shapes")) {
                shapes.add(shape(shape));
            }
            Pose pose = new Pose(vector(link, "position").minus(origin), Rotation.NONE);
            return new RobotBody(
                    text(link, "name"), parent, SimSparkFrame.toBody(pose), 0, Pose.ORIGIN, Vector3.ZERO, shapes);
        }

        private Vector3 position(int link) {
            return vector(links.get(link), "position");
        }

        private static PlacedShape shape(JsonElement json) {
            Vector3 size = vector(json, "size");
            String kind = text(json, "kind");
            Shape shape = switch (kind) {
                case "box" -> new Shape.Box(new Vector3(size.y(), size.x(), size.z()));
                case "sphere" -> new Shape.Sphere(size.x() / 2);
                case "capsule" -> new Shape.Capsule(size.x() / 2, size.z() - size.x());
                default ->
                    throw new IllegalArgumentException(
                            "The shape \"" + kind + "\" is none of box, sphere and capsule.");
            };
            List<Double> turn = numbers(json, "rotation", 4);
            Rotation rotation = new Rotation(turn.get(0), turn.get(1), turn.get(2), turn.get(3));
            return new PlacedShape(shape, SimSparkFrame.toBody(new Pose(vector(json, "position"), rotation)), true);
        }

        private RobotJoint joint(JsonElement hinge, int index) {
            int child = link(hinge, "child");
            return new RobotJoint(
                    index,
                    text(hinge, "joint"),
                    text(hinge, "sensor"),
                    text(hinge, "effector"),
                    child,
                    SimSparkFrame.toBody(vector(hinge, "anchor").minus(position(child))),
                    SimSparkFrame.toBody(vector(hinge, "axis")),
                    number(hinge, "minDegrees"),
                    number(hinge, "maxDegrees"),
                    motor(hinge),
                    number(hinge, "stanceDegrees"));
        }

        private static Motor motor(JsonElement hinge) {
            return hinge.getAsJsonObject().has("maxTorque")
                    ? new Motor.Torque(number(hinge, "maxTorque"), number(hinge, "stiffness"), number(hinge, "damping"))
                    : Motor.Speed.ofDegrees(number(hinge, "maxSpeed"));
        }

        private int link(JsonElement hinge, String name) {
            double index = number(hinge, name);
            if (index != PortableMath.rint(index) || index < 0 || index >= links.size()) {
                throw new IllegalArgumentException("The model has no link " + index + ".");
            }
            return (int) index;
        }

        private static Vector3 vector(JsonElement json, String name) {
            List<Double> numbers = numbers(json, name, 3);
            return new Vector3(numbers.get(0), numbers.get(1), numbers.get(2));
        }

        private static List<Double> numbers(JsonElement json, String name, int count) {
            JsonArray array = array(json, name);
            if (array.size() != count) {
                throw new IllegalArgumentException(
                        "\"" + name + "\" has " + array.size() + " elements instead of " + count + ".");
            }
            List<Double> numbers = new ArrayList<>();
            array.forEach(element -> numbers.add(number(name, element)));
            return numbers;
        }

        private static double number(JsonElement json, String name) {
            return number(name, member(json, name));
        }

        private static double number(String name, JsonElement element) {
            boolean isNumber =
                    element.isJsonPrimitive() && element.getAsJsonPrimitive().isNumber();
            double number = isNumber ? element.getAsDouble() : Double.NaN;
            if (!(Math.abs(number) <= MAX_NUMBER)) {
                throw new IllegalArgumentException("\"" + name + "\" is not a number.");
            }
            return number;
        }

        private static String text(JsonElement json, String name) {
            JsonElement element = member(json, name);
            if (!element.isJsonPrimitive()) {
                throw new IllegalArgumentException("\"" + name + "\" is not a text.");
            }
            return element.getAsString();
        }

        private static JsonArray array(JsonElement json, String name) {
            JsonElement element = member(json, name);
            if (!element.isJsonArray()) {
                throw new IllegalArgumentException("\"" + name + "\" is not a list.");
            }
            return element.getAsJsonArray();
        }

        private static JsonElement member(JsonElement json, String name) {
            JsonElement element = json.isJsonObject() ? json.getAsJsonObject().get(name) : null;
            if (element == null) {
                throw new IllegalArgumentException("The model lacks \"" + name + "\".");
            }
            return element;
        }
    }
}
