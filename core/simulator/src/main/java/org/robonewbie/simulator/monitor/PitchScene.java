package org.robonewbie.simulator.monitor;

import java.util.ArrayList;
import java.util.List;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.protocol.monitor.LightNode;
import org.robonewbie.protocol.monitor.LightNode.Colour;
import org.robonewbie.protocol.monitor.MeshNode;
import org.robonewbie.protocol.monitor.MeshNode.MeshFile;
import org.robonewbie.protocol.monitor.MeshNode.StandardShape;
import org.robonewbie.protocol.monitor.TransformNode;
import org.robonewbie.simulator.soccer.SoccerParameter;
import org.robonewbie.simulator.soccer.SoccerParameters;

/**
 * The 36 top-level nodes of the empty scene: lights, ground, sky, goals, walls, flags, lines and ball. Monitors rely on this order.
 * Source: a recording of rcssserver3d 0.7.3 and SimSpark's {@code soccer.rsg}, {@code goal.rsg}, {@code ball.rsg}.
 */
final class PitchScene {

    private static final int LINES = 21;
    private static final float GOAL_WALL = 0.04f;
    private static final float BORDER_PER_LENGTH = 0.333f;
    private static final float BORDER_PER_WIDTH = 0.75f;
    private static final List<String> SKY_MATERIALS = List.of(
            "Material_skyrender_0001.tif",
            "Material_skyrender_0002.tif",
            "Material_skyrender_0003.tif",
            "Material_skyrender_0004.tif",
            "Material_skyrender_0005.tif",
            "Material_skyrender_0006.tif");

    private final float length;
    private final float width;
    private final float goalWidth;
    private final float goalDepth;
    private final float goalHeight;
    private final List<TransformNode> nodes = new ArrayList<>();
    private final TransformNode ball;

    PitchScene(SoccerParameters parameters) {
        SoccerField field = parameters.field();
        length = (float) field.length();
        width = (float) field.width();
        goalWidth = (float) field.goalWidth();
        goalDepth = (float) field.goalDepth();
        goalHeight = (float) field.goalHeight();
        float radius = (float) parameters.get(SoccerParameter.BALL_RADIUS);
        ball = TransformNode.at(
                0,
                0,
                radius,
                mesh("soccerball", radius, radius, radius, List.of("soccerball_rcs-soccerball.png"), false));
        addLights();
        addGroundAndSky();
        addGoals();
        addWalls();
        addFlagsAndLines();
        nodes.add(ball);
    }

    List<TransformNode> nodes() {
        return nodes;
    }

    TransformNode ball() {
        return ball;
    }

    private void addLights() {
        Colour highlight = Colour.grey(0.1f);
        nodes.add(TransformNode.at(-10, 10, 10, new LightNode(Colour.grey(1), Colour.grey(0.8f), highlight)));
        nodes.add(TransformNode.at(10, -10, 10, new LightNode(Colour.grey(1), Colour.grey(0), highlight)));
    }

    private void addGroundAndSky() {
        float[] lying = SceneRotation.transform(0, 0, 0, 90, 180, 0);
        List<String> grass = List.of("None_rcs-naofield.png");
        nodes.add(new TransformNode(lying, List.of(mesh("naosoccerfield", length / 12, 1, width / 8, grass, false))));
        nodes.add(new TransformNode(lying, List.of(mesh("skybox", 10, 10, 10, SKY_MATERIALS, false))));
    }

    private void addGoals() {
        float x = length / 2 + goalDepth / 2;
        float z = goalHeight / 2;
        nodes.add(TransformNode.at(-x, 0, z).with(goalParts("leftsoccergoal", "yellow")));
        nodes.add(new TransformNode(
                SceneRotation.transform(x, 0, z, 0, 0, 180), goalParts("rightsoccergoal", "sky-blue")));
    }

    /** Returns the net and the empty nodes of three walls, the crossbar and both posts. */
    private List<TransformNode> goalParts(String name, String colour) {
        float halfDepth = goalDepth / 2;
        float halfWidth = goalWidth / 2;
        float halfHeight = goalHeight / 2;
        float halfWall = GOAL_WALL / 2;
        MeshNode net = mesh(
                name,
                goalWidth + 2 * GOAL_WALL,
                goalHeight + 2 * GOAL_WALL,
                goalDepth + 2 * GOAL_WALL,
                List.of("naogoalnet", colour),
                true);
        return List.of(
                new TransformNode(SceneRotation.transform(halfDepth, 0, -halfHeight, 90, 90, 0), List.of(net)),
                TransformNode.at(0, -(halfWidth + halfWall), 0),
                TransformNode.at(0, halfWidth + halfWall, 0),
                TransformNode.at(-(halfDepth - halfWall), 0, 0),
                TransformNode.at(0, 0, halfHeight + halfWall),
                TransformNode.at(halfDepth, halfWidth, halfHeight),
                TransformNode.at(halfDepth, -halfWidth, halfHeight));
    }

    private void addWalls() {
        float x = length / 2 + BORDER_PER_LENGTH * length;
        float y = width / 2 + BORDER_PER_WIDTH * width;
        nodes.add(TransformNode.at(-x, 0, 0, box(1, 2 * y + 1, 1)));
        nodes.add(TransformNode.at(x, 0, 0, box(1, 2 * y + 1, 1)));
        nodes.add(TransformNode.at(0, y, 0, box(2 * x + 1, 1, 1)));
        nodes.add(TransformNode.at(0, -y, 0, box(2 * x + 1, 1, 1)));
    }

    private void addFlagsAndLines() {
        nodes.add(TransformNode.at(-length / 2, width / 2, 0));
        nodes.add(TransformNode.at(-length / 2, -width / 2, 0));
        nodes.add(TransformNode.at(length / 2, width / 2, 0));
        nodes.add(TransformNode.at(length / 2, -width / 2, 0));
        for (int i = 0; i < LINES; i++) {
            nodes.add(TransformNode.at(0, 0, 0));
        }
    }

    /** Returns a grey box in the format that SimSpark uses for the outer walls. */
    static MeshNode box(float sizeX, float sizeY, float sizeZ) {
        return new MeshNode(
                new StandardShape("StdUnitBox", List.of()), sizeX, sizeY, sizeZ, List.of("matGrey"), false, true);
    }

    private static MeshNode mesh(
            String name, float scaleX, float scaleY, float scaleZ, List<String> materials, boolean transparent) {
        MeshFile file = new MeshFile("models/" + name + ".obj", List.of());
        return new MeshNode(file, scaleX, scaleY, scaleZ, materials, transparent, true);
    }
}
