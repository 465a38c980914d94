package org.robonewbie.simulator.export;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.nao.model.Shape;
import org.robonewbie.robot.Motor;
import org.robonewbie.robot.PlacedShape;
import org.robonewbie.robot.RobotBody;
import org.robonewbie.robot.RobotJoint;
import org.robonewbie.robot.RobotModel;
import org.robonewbie.simulator.world.BallProperties;
import org.robonewbie.simulator.world.Robot;

/**
 * A robot of the simulator in MuJoCo's format MJCF, with x forward, y left and z up. The names of motors and sensors are those of SimSpark's messages, such as
 * {@code lle4} and {@code llj4}. Bodies and joints equal those of the simulator; motors and contacts are only similar, because MuJoCo
 * computes both in another way.
 */
public final class MjcfFile {

    /** Name of the torso in exported files; SimSpark's {@code body} would say little there. */
    static final String TORSO = "torso";

    /** Names of the force sensors in SimSpark's messages by their links. */
    private static final Map<String, String> FORCE_SENSORS =
            Map.of("rfoot", "rf", "lfoot", "lf", "rtoe", "rf1", "ltoe", "lf1");

    private static final double TIMESTEP = 0.005;
    // Fitted to recordings of rcssserver3d by research/python/benchmarks/fit_mujoco.py.
    private static final double STIFFNESS = 660;
    private static final double STIFF_DAMPING = 0.42;
    private static final double ARMATURE = 0.027;
    private static final double DAMPING = 0.0015;
    private static final String FRICTION = "1.46 0.0044 0.0001";
    private static final String SOLREF = "0.0165 1";
    private static final String SOLIMP = "0.826 0.99 0.001";
    // Soft enough to walk, stiff enough to stand.
    private static final double SOFTNESS = 60;
    private static final double SOFT_DAMPING = 1;
    private static final double SENSOR_MARGIN = 0.005;
    private static final double LINE_WIDTH = 0.05;
    private static final double LINE_HEIGHT = 0.001;
    private static final double GOAL_WALL = 0.04;
    private static final double BALL_X = 1;

    private final MotorKind motors;
    private final ExportedScene scene;
    private final RobotModel robot;
    private final XmlText xml;

    private MjcfFile(RobotModel robot, MotorKind motors, ExportedScene scene, String head) {
        this.robot = robot;
        this.motors = motors;
        this.scene = scene;
        xml = new XmlText(head);
    }

    /**
     * Describes a robot on the ground, with all joints at 0.
     *
     * @param robot the robot; its bodies are parallel to their parents while all joints are at 0°
     * @param motors what the motors are given
     * @param scene what surrounds the robot
     * @param head text of the comment at the beginning, such as licence and version; without two hyphens in a row
     * @return the contents of the file
     */
    public static String of(RobotModel robot, MotorKind motors, ExportedScene scene, String head) {
        return new MjcfFile(robot, motors, scene, head).written();
    }

    private String written() {
        xml.begin("mujoco", "model", robot.name());
        xml.add("compiler", "angle", "degree", "autolimits", "true");
        xml.add("option", "timestep", TIMESTEP, "integrator", "implicitfast");
        addDefaults();
        addAssets();
        xml.begin("worldbody");
        addGround();
        addBody(0);
        if (scene == ExportedScene.PITCH) {
            addPitch(SoccerField.BEGINNER);
        }
        xml.end("worldbody");
        addMotors();
        addSensors();
        xml.end("mujoco");
        return xml.toString();
    }

    private void addDefaults() {
        xml.begin("default");
        xml.add("joint", "armature", ARMATURE, "damping", DAMPING);
        // Parts of one robot do not collide with each other, as in SimSpark: they are of type 1 and meet type 2 only.
        xml.add("geom", "material", "white", "contype", 1, "conaffinity", 2);
        xml.begin("default", "class", "inner");
        xml.add("geom", "contype", 0, "conaffinity", 0, "material", "dark");
        xml.end("default");
        xml.begin("default", "class", "scenery");
        xml.add(
                "geom",
                "contype",
                2,
                "conaffinity",
                3,
                "friction",
                FRICTION,
                "solref",
                SOLREF,
                "solimp",
                SOLIMP,
                "priority",
                1);
        xml.end("default");
        xml.begin("default", "class", "line");
        xml.add("geom", "type", "box", "contype", 0, "conaffinity", 0, "material", "white");
        xml.end("default");
        xml.end("default");
    }

    private void addAssets() {
        xml.begin("asset");
        xml.add("material", "name", "white", "rgba", "0.95 0.95 0.95 1");
        xml.add("material", "name", "dark", "rgba", "0.25 0.25 0.28 1");
        xml.add("material", "name", "team", "rgba", "0.1 0.36 0.84 1");
        xml.add("material", "name", "grass", "rgba", "0.25 0.55 0.3 1");
        xml.end("asset");
    }

    private void addGround() {
        xml.add("light", "pos", "0 0 5", "dir", "0.2 0.2 -1", "directional", "true");
        xml.add("geom", "name", "ground", "type", "plane", "size", "20 20 1", "material", "grass", "class", "scenery");
    }

    private void addPitch(SoccerField field) {
        addLines(field);
        addGoal("left", -1, field);
        addGoal("right", 1, field);
        addBall();
    }

    private void addLines(SoccerField field) {
        double x = field.length() / 2;
        double y = field.width() / 2;
        addLine(0, y, x, LINE_WIDTH / 2);
        addLine(0, -y, x, LINE_WIDTH / 2);
        addLine(-x, 0, LINE_WIDTH / 2, y);
        addLine(0, 0, LINE_WIDTH / 2, y);
        addLine(x, 0, LINE_WIDTH / 2, y);
        double front = x - field.penaltyLength();
        double side = (field.goalWidth() + field.penaltyWidth()) / 2;
        for (int end : new int[] {-1, 1}) {
            addLine(end * front, 0, LINE_WIDTH / 2, side);
            addLine(end * (front + x) / 2, side, field.penaltyLength() / 2, LINE_WIDTH / 2);
            addLine(end * (front + x) / 2, -side, field.penaltyLength() / 2, LINE_WIDTH / 2);
        }
    }

    private void addLine(double x, double y, double halfX, double halfY) {
        xml.add("geom", "class", "line", "pos", new Vector3(x, y, 0), "size", new Vector3(halfX, halfY, LINE_HEIGHT));
    }

    private void addGoal(String name, int end, SoccerField field) {
        double depth = field.goalDepth();
        double half = field.goalWidth() / 2;
        double height = field.goalHeight();
        double x = end * (field.length() + depth) / 2;
        xml.begin("body", "name", "goal_" + name, "pos", new Vector3(x, 0, height / 2));
        addWall(new Vector3(0, half + GOAL_WALL / 2, 0), new Vector3(depth, GOAL_WALL, height));
        addWall(new Vector3(0, -half - GOAL_WALL / 2, 0), new Vector3(depth, GOAL_WALL, height));
        addWall(new Vector3(end * (depth - GOAL_WALL) / 2, 0, 0), new Vector3(GOAL_WALL, 2 * half, height));
        addWall(new Vector3(0, 0, (height + GOAL_WALL) / 2), new Vector3(depth, 2 * (half + GOAL_WALL), GOAL_WALL));
        xml.end("body");
    }

    private void addWall(Vector3 centre, Vector3 size) {
        xml.add("geom", "class", "scenery", "type", "box", "pos", centre, "size", size.times(0.5), "rgba", "1 1 1 0.4");
    }

    private void addBall() {
        BallProperties ball = BallProperties.STANDARD;
        xml.begin("body", "name", "ball", "pos", new Vector3(BALL_X, 0, ball.radius()));
        xml.add("freejoint", "name", "ball");
        xml.add("geom", "class", "scenery", "type", "sphere", "size", ball.radius(), "mass", ball.massKg());
        xml.end("body");
    }

    /** Adds a body and the bodies that it carries. */
    private void addBody(int index) {
        RobotBody body = robot.bodies().get(index);
        Vector3 place = index == 0
                ? new Vector3(0, 0, robot.stanceHeight())
                : body.pose().position();
        xml.begin("body", "name", index == 0 ? TORSO : body.name(), "pos", place);
        if (index == 0) {
            xml.add("freejoint", "name", "root");
            xml.add("site", "name", TORSO);
        }
        robot.joints().stream().filter(joint -> joint.body() == index).forEach(this::addJoint);
        xml.add(
                "inertial",
                "pos",
                body.inertialPose().position(),
                "mass",
                body.massKg(),
                "diaginertia",
                body.inertia());
        body.shapes().forEach(placed -> addShape(body, placed));
        for (int i = index + 1; i < robot.bodies().size(); i++) {
            if (robot.bodies().get(i).parent() == index) {
                addBody(i);
            }
        }
        xml.end("body");
    }

    private void addJoint(RobotJoint joint) {
        String range = XmlText.numbers(joint.minDegrees(), joint.maxDegrees());
        xml.add("joint", "name", joint.perceptorName(), "pos", joint.anchor(), "axis", joint.axis(), "range", range);
    }

    private void addShape(RobotBody body, PlacedShape placed) {
        String look = placed.collides() ? "material" : "class";
        String value = placed.collides() ? (body.name().endsWith("thigh") ? "team" : "white") : "inner";
        if (placed.shape() instanceof Shape.Box box) {
            xml.add("geom", "type", "box", "size", box.size().times(0.5), look, value);
        } else if (placed.shape() instanceof Shape.Capsule capsule) {
            String size = XmlText.numbers(capsule.radius(), capsule.length() / 2);
            xml.add("geom", "type", "capsule", "size", size, look, value);
        } else {
            xml.add("geom", "type", "sphere", "size", ((Shape.Sphere) placed.shape()).radius(), look, value);
        }
        if (body.name().equals("head")) {
            xml.add("site", "name", "camera");
        }
        if (FORCE_SENSORS.containsKey(body.name())) {
            Vector3 margin = new Vector3(SENSOR_MARGIN, SENSOR_MARGIN, SENSOR_MARGIN);
            Vector3 half = placed.shape().size().times(0.5).plus(margin);
            xml.add("site", "name", body.name(), "type", "box", "size", half, "rgba", "0 0 0 0");
        }
    }

    private void addMotors() {
        xml.begin("actuator");
        robot.joints().forEach(this::addMotor);
        xml.end("actuator");
    }

    private void addMotor(RobotJoint joint) {
        String torque = XmlText.numbers(-Robot.MAX_TORQUE, Robot.MAX_TORQUE);
        String angles =
                XmlText.numbers(PortableMath.toRadians(joint.minDegrees()), PortableMath.toRadians(joint.maxDegrees()));
        String speeds = XmlText.numbers(-maxRadiansPerSecond(joint), maxRadiansPerSecond(joint));
        List<Object> attributes =
                new ArrayList<>(List.of("name", joint.effectorName(), "joint", joint.perceptorName()));
        switch (motors) {
            // It holds its angle while the speed is 0, as in SimSpark; MuJoCo's element "velocity" would give way.
            case SPEED ->
                attributes.addAll(List.of(
                        "kp",
                        STIFFNESS,
                        "kv",
                        STIFF_DAMPING,
                        "ctrlrange",
                        speeds,
                        "actrange",
                        angles,
                        "forcerange",
                        torque));
            case POSITION ->
                attributes.addAll(
                        List.of("kp", SOFTNESS, "kv", SOFT_DAMPING, "ctrlrange", angles, "forcerange", torque));
            case TORQUE -> attributes.addAll(List.of("ctrlrange", torque));
        }
        xml.add(element(), attributes.toArray());
    }

    /** Returns the maximum speed of a motor that is commanded by speed. */
    static double maxRadiansPerSecond(RobotJoint joint) {
        return PortableMath.toRadians(((Motor.Speed) joint.motor()).maxDegreesPerSecond());
    }

    private String element() {
        return switch (motors) {
            case SPEED -> "intvelocity";
            case POSITION -> "position";
            case TORQUE -> "motor";
        };
    }

    private void addSensors() {
        xml.begin("sensor");
        xml.add("gyro", "name", "torso_gyro", "site", TORSO);
        xml.add("accelerometer", "name", "torso_acc", "site", TORSO);
        xml.add("framepos", "name", "torso_pos", "objtype", "site", "objname", TORSO);
        xml.add("framequat", "name", "torso_quat", "objtype", "site", "objname", TORSO);
        for (RobotBody body : robot.bodies()) {
            if (FORCE_SENSORS.containsKey(body.name())) {
                xml.add("touch", "name", FORCE_SENSORS.get(body.name()), "site", body.name());
            }
        }
        for (RobotJoint joint : robot.joints()) {
            xml.add("jointpos", "name", joint.perceptorName(), "joint", joint.perceptorName());
        }
        for (RobotJoint joint : robot.joints()) {
            xml.add("jointvel", "name", joint.perceptorName() + "_speed", "joint", joint.perceptorName());
        }
        xml.end("sensor");
    }
}
