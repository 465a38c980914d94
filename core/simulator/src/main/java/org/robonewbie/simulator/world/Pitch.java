package org.robonewbie.simulator.world;

import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.Shape;
import org.robonewbie.simulator.physics.Assembly;
import org.robonewbie.simulator.physics.BodyPose;
import org.robonewbie.simulator.physics.PhysicsWorld;
import org.robonewbie.simulator.physics.RotationMatrix;

/** Builder of the static environment: ground, outer walls and goals (SimSpark: soccer.rsg, goal.rsg). */
final class Pitch {

    /** Owner of the colliders of the ground and the walls. */
    static final Object SCENERY = new Object();

    private static final BodyPose ORIGIN = new BodyPose(Vector3.ZERO, RotationMatrix.IDENTITY);
    private static final double WALL_THICKNESS = 1;
    private static final double GOAL_WALL_THICKNESS = 0.04;
    private static final double BORDER_PER_LENGTH = 0.333;
    private static final double BORDER_PER_WIDTH = 0.75;

    private final PhysicsWorld engine;
    private final SoccerField field;
    private final double ballRadius;

    Pitch(PhysicsWorld engine, SoccerField field, double ballRadius) {
        this.engine = engine;
        this.field = field;
        this.ballRadius = ballRadius;
    }

    /** Owner of the trigger inside a goal. */
    record GoalMouth(TeamSide side) {}

    void build() {
        engine.addGround(SurfaceMaterials.GROUND, SCENERY);
        addGoal(TeamSide.LEFT);
        addGoal(TeamSide.RIGHT);
        addOuterWalls();
    }

    private void addOuterWalls() {
        double borderLength = BORDER_PER_LENGTH * field.length();
        double borderWidth = BORDER_PER_WIDTH * field.width();
        double x = field.length() / 2 + borderLength;
        double y = field.width() / 2 + borderWidth;
        Vector3 besideGoals =
                new Vector3(WALL_THICKNESS, field.width() + 2 * borderWidth + WALL_THICKNESS, WALL_THICKNESS);
        Vector3 besideLines =
                new Vector3(field.length() + 2 * borderLength + WALL_THICKNESS, WALL_THICKNESS, WALL_THICKNESS);
        Assembly scenery = engine.scenery();
        addWall(scenery, ORIGIN, new Vector3(-x, 0, 0), besideGoals);
        addWall(scenery, ORIGIN, new Vector3(x, 0, 0), besideGoals);
        addWall(scenery, ORIGIN, new Vector3(0, y, 0), besideLines);
        addWall(scenery, ORIGIN, new Vector3(0, -y, 0), besideLines);
    }

    private void addGoal(TeamSide side) {
        double direction = side == TeamSide.LEFT ? -1 : 1;
        BodyPose goal = new BodyPose(
                new Vector3(direction * (field.length() + field.goalDepth()) / 2, 0, field.goalHeight() / 2),
                RotationMatrix.aboutZ(side == TeamSide.LEFT ? 0 : Math.PI));
        Assembly parts = engine.addAssembly();
        double depth = field.goalDepth();
        double width = field.goalWidth();
        double height = field.goalHeight();
        double thick = GOAL_WALL_THICKNESS;
        addTrigger(parts, goal, side);
        addWall(parts, goal, new Vector3(0, (width + thick) / 2, 0), new Vector3(depth, thick, height));
        addWall(parts, goal, new Vector3(0, -(width + thick) / 2, 0), new Vector3(depth, thick, height));
        addWall(parts, goal, new Vector3((thick - depth) / 2, 0, 0), new Vector3(thick, width, height));
        addWall(parts, goal, new Vector3(0, 0, (height + thick) / 2), new Vector3(depth, width + 2 * thick, thick));
    }

    /**
     * Adds the trigger inside a goal. Its sides are a ball radius inside those of the goal, so that a ball touches it
     * only when its centre is inside the goal.
     */
    private void addTrigger(Assembly parts, BodyPose goal, TeamSide side) {
        Vector3 size =
                new Vector3(field.goalDepth() - 2 * ballRadius, field.goalWidth() - 2 * ballRadius, field.goalHeight());
        parts.addTrigger(goal, new Shape.Box(size), new GoalMouth(side));
    }

    private static void addWall(Assembly assembly, BodyPose frame, Vector3 centre, Vector3 size) {
        BodyPose pose = new BodyPose(frame.toWorld(centre), frame.rotation());
        assembly.addFixture(pose, new Shape.Box(size), SurfaceMaterials.WALL, SCENERY);
    }
}
