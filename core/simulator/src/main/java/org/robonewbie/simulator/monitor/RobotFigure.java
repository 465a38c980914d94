package org.robonewbie.simulator.monitor;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.model.Link;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.protocol.monitor.MeshNode;
import org.robonewbie.protocol.monitor.MeshNode.StandardShape;
import org.robonewbie.protocol.monitor.SceneNode;
import org.robonewbie.protocol.monitor.TransformNode;
import org.robonewbie.protocol.order.PlayerNumber;

/** A robot in the monitors' scene: one top-level node, with a child node for each link in world coordinates. */
final class RobotFigure {

    private static final String ANY_TEAM = "matTeam";
    private static final String ANY_NUMBER = "matNum";

    private final RobotType type;
    private final List<TransformNode> parts = new ArrayList<>();
    private final List<ColouredMesh> coloured = new ArrayList<>();
    private final MeshNode marker = new MeshNode(
            new StandardShape("StdUnitCylinder", List.of("1", "1")),
            0.2f,
            0.2f,
            0.02f,
            List.of("matSelect"),
            true,
            false);
    private final TransformNode root;
    private Optional<PlayerNumber> player = Optional.empty();

    RobotFigure(RobotType type) {
        this.type = type;
        for (Link link : NaoModel.of(type).links()) {
            parts.add(TransformNode.at(0, 0, 0).with(contents(link)));
        }
        root = TransformNode.at(0, 0, 0).with(parts);
    }

    TransformNode root() {
        return root;
    }

    RobotType type() {
        return type;
    }

    /** Updates the nodes; returns whether the colours have changed, which requires a full message. */
    boolean update(MonitoredRobotState state) {
        for (int i = 0; i < parts.size(); i++) {
            parts.get(i).moveTo(state.transforms(), MonitoredRobotState.TRANSFORM_SIZE * i);
        }
        marker.setVisible(state.selected());
        boolean recoloured = !state.player().equals(player);
        if (recoloured) {
            player = state.player();
            coloured.forEach(mesh -> mesh.colour(player));
        }
        return recoloured;
    }

    private List<SceneNode> contents(Link link) {
        RobotMeshes.Look look = new RobotMeshes(type).look(link);
        MeshNode mesh = look.mesh();
        coloured.add(new ColouredMesh(mesh, mesh.materials()));
        SceneNode shown =
                look.lying() ? new TransformNode(SceneRotation.transform(0, 0, 0, -90, 0, 180), List.of(mesh)) : mesh;
        return link.name().equals(NaoModel.TORSO) ? List.of(shown, TransformNode.at(0, 0, 0, marker)) : List.of(shown);
    }

    /** A mesh and its materials before the robot joins a team. */
    private record ColouredMesh(MeshNode mesh, List<String> plain) {

        void colour(Optional<PlayerNumber> player) {
            mesh.setMaterials(
                    plain.stream().map(material -> coloured(material, player)).toList());
        }

        private static String coloured(String material, Optional<PlayerNumber> player) {
            if (player.isEmpty()) {
                return material;
            }
            return switch (material) {
                case ANY_TEAM -> player.get().side() == TeamSide.LEFT ? "matLeft" : "matRight";
                case ANY_NUMBER -> ANY_NUMBER + player.get().number();
                default -> material;
            };
        }
    }
}
