package org.robonewbie.simulator.landscape;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.kinematics.Rotation;
import org.robonewbie.nao.math.PortableMath;

/**
 * Set of objects on the pitch: none in a soccer match, otherwise obstacles to walk around, climb or push. The
 * command-line option {@code --scene} selects one.
 *
 * <pre>{@code
 * WorldSettings settings = WorldSettings.beginner().withLandscape(Landscape.SLOPE);
 * }</pre>
 *
 * @param name name on the command line
 * @param description short description for the command-line help
 * @param things the objects in their initial poses
 */
public record Landscape(String name, String description, List<Thing> things) {

    private static final double WALL_HEIGHT = 0.3;
    private static final double WALL_THICKNESS = 0.1;
    private static final double WALL_KG = 2;
    private static final double POST_WIDTH = 0.12;
    private static final double POST_HEIGHT = 0.6;
    private static final double POST_KG = 0.5;

    private static final double HILL_BEGIN = -4.2;
    private static final double HILL_WIDTH = 2;
    private static final double SLOPE_DEGREES = 5;
    private static final double SLOPE_LENGTH = 1.2;
    private static final double SLOPE_THICKNESS = 0.2;
    private static final double TOP_LENGTH = 0.7;
    private static final double STEP_LENGTH = 0.35;
    private static final int STEPS = 2;

    /** The bare pitch. */
    public static final Landscape SOCCER = new Landscape("soccer", "the bare pitch", List.of());

    /** Two walls and two posts, light enough that a collision visibly moves them. */
    public static final Landscape OBSTACLES = new Landscape(
            "obstacles",
            "two walls and two posts to walk around",
            List.of(wall(-3.6, 0.7), post(-3.6, -1.3), wall(-2.2, -0.7), post(-2.2, 1.3)));

    /** A hill with a slope, a level top and steps down. */
    public static final Landscape SLOPE =
            new Landscape("slope", "a hill: a slope of 5 degrees, a level top, and two steps down", hill());

    /** A box that is wide enough for two robots to push side by side. */
    public static final Landscape BOX = new Landscape(
            "box",
            "a wide box that robots can push, alone or together",
            List.of(Thing.movable("box", new Vector3(0.4, 1.6, 0.4), new Vector3(-3.2, 0, 0.2), 4)));

    /** All landscapes, the bare pitch first. */
    public static final List<Landscape> ALL = List.of(SOCCER, OBSTACLES, SLOPE, BOX);

    /** Stores an unmodifiable copy of the list of objects. */
    public Landscape {
        things = List.copyOf(things);
    }

    /**
     * Looks up a landscape.
     *
     * @param name name as given by the user
     * @return the landscape
     * @throws IllegalArgumentException if the name is unknown; the message lists all names
     */
    public static Landscape named(String name) {
        return ALL.stream()
                .filter(landscape -> landscape.name.equals(name))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException("There is no scene \"" + name + "\". Choose one of "
                        + ALL.stream().map(Landscape::name).collect(Collectors.joining(", ")) + "."));
    }

    /** {@return whether the pitch is bare} */
    public boolean isBare() {
        return things.isEmpty();
    }

    private static Thing wall(double x, double y) {
        return Thing.movable(
                "wall", new Vector3(WALL_THICKNESS, 2, WALL_HEIGHT), new Vector3(x, y, WALL_HEIGHT / 2), WALL_KG);
    }

    private static Thing post(double x, double y) {
        return Thing.movable(
                "post", new Vector3(POST_WIDTH, POST_WIDTH, POST_HEIGHT), new Vector3(x, y, POST_HEIGHT / 2), POST_KG);
    }

    /** Returns a slope that rises towards positive x, a level top, and steps down. */
    private static List<Thing> hill() {
        double radians = PortableMath.toRadians(SLOPE_DEGREES);
        double cosine = PortableMath.cos(radians);
        double sine = PortableMath.sin(radians);
        double height = SLOPE_LENGTH * sine;
        Vector3 middleOfSlope = new Vector3(
                HILL_BEGIN + SLOPE_LENGTH / 2 * cosine + SLOPE_THICKNESS / 2 * sine,
                0,
                height / 2 - SLOPE_THICKNESS / 2 * cosine);
        List<Thing> parts = new ArrayList<>();
        parts.add(Thing.fixed("slope", new Vector3(SLOPE_LENGTH, HILL_WIDTH, SLOPE_THICKNESS), middleOfSlope)
                .at(new Pose(middleOfSlope, Rotation.about(new Vector3(0, 1, 0), -SLOPE_DEGREES))));
        double x = HILL_BEGIN + SLOPE_LENGTH * cosine;
        parts.add(block("top", x, TOP_LENGTH, height));
        x += TOP_LENGTH;
        for (int i = STEPS; i > 0; i--) {
            parts.add(block("step", x, STEP_LENGTH, height * i / (STEPS + 1)));
            x += STEP_LENGTH;
        }
        return parts;
    }

    private static Thing block(String name, double x, double length, double height) {
        return Thing.fixed(name, new Vector3(length, HILL_WIDTH, height), new Vector3(x + length / 2, 0, height / 2));
    }
}
