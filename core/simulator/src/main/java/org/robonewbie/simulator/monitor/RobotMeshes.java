package org.robonewbie.simulator.monitor;

import java.util.List;
import org.robonewbie.nao.model.Link;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.model.Shape;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.monitor.MeshNode;
import org.robonewbie.protocol.monitor.MeshNode.MeshFile;
import org.robonewbie.protocol.monitor.MeshNode.StandardShape;
import org.robonewbie.protocol.sexp.SexpWriter;

/**
 * The meshes of a robot's links: mesh files that the monitors provide, and primitive shapes for the links inside joints.
 * Source: a recording of rcssserver3d 0.7.3 and SimSpark's NAO scene files.
 */
final class RobotMeshes {

    private static final float FOOT_SCALE = 0.08f;
    private static final double WHOLE_FOOT_LENGTH = 0.16;
    private static final double FOOT_HEIGHT = 0.02;

    private final String materialOfType;
    private final int typeNumber;

    RobotMeshes(RobotType type) {
        typeNumber = type.ordinal();
        materialOfType = "matType" + typeNumber;
    }

    /** The mesh of a link, and whether the link lies on its back in the mesh file. */
    record Look(MeshNode mesh, boolean lying) {}

    Look look(Link link) {
        String name = link.name();
        if (name.equals(NaoModel.TORSO)) {
            return new Look(
                    mesh("nao" + name + typeNumber, 0.1f, "matNum", "matTeam", materialOfType, "naowhite"), true);
        }
        if (name.equals("head")) {
            return new Look(mesh("naohead", 0.1f, "matTeam", "naoblack", "naogrey", "naowhite"), true);
        }
        return new Look(name.equals("neck") ? neck(link.shape()) : limb(link), false);
    }

    private MeshNode limb(Link link) {
        String name = link.name();
        return switch (name.substring(1)) {
            case "upperarm" -> mesh(name + typeNumber, 0.07f, "matTeam", materialOfType, "naowhite");
            case "lowerarm" -> mesh(name, 0.05f, "matTeam", "naowhite");
            case "thigh" -> thigh(name);
            case "shank" -> mesh(name + typeNumber, 0.08f, "matTeam", materialOfType, "naowhite");
            case "foot", "toe" -> foot(name.substring(0, 1) + "foot", (Shape.Box) link.shape());
            case "ankle" -> ball(link.shape(), "matRed");
            default -> ball(link.shape(), "matYellow");
        };
    }

    /** Returns the mesh of a thigh; only the right one shows the uniform number. */
    private static MeshNode thigh(String name) {
        return name.startsWith("r")
                ? mesh(name, 0.07f, "matNum", "matTeam", "naowhite")
                : mesh(name, 0.07f, "matTeam", "naowhite");
    }

    /** Returns the foot mesh, scaled to the length and height of a foot or toe. */
    private static MeshNode foot(String name, Shape.Box box) {
        return new MeshNode(
                new MeshFile(path(name), List.of()),
                FOOT_SCALE,
                (float) (FOOT_SCALE * box.size().y() / WHOLE_FOOT_LENGTH),
                (float) (FOOT_SCALE * box.size().z() / FOOT_HEIGHT),
                List.of("matTeam", "naowhite"),
                false,
                true);
    }

    private static MeshNode neck(Shape shape) {
        Shape.Capsule capsule = (Shape.Capsule) shape;
        List<String> size = List.of(text(capsule.radius()), text(capsule.length()));
        return new MeshNode(new StandardShape("StdCapsule", size), 1, 1, 1, List.of("matDarkGrey"), false, true);
    }

    private static MeshNode ball(Shape shape, String material) {
        float radius = (float) ((Shape.Sphere) shape).radius();
        return new MeshNode(
                new StandardShape("StdUnitSphere", List.of()), radius, radius, radius, List.of(material), false, true);
    }

    private static MeshNode mesh(String name, float scale, String... materials) {
        return new MeshNode(new MeshFile(path(name), List.of()), scale, scale, scale, List.of(materials), false, true);
    }

    private static String path(String name) {
        return "models/" + name + ".obj";
    }

    private static String text(double number) {
        MessageBuffer buffer = new MessageBuffer();
        new SexpWriter(buffer).general(number);
        return buffer.toString();
    }
}
