package org.robonewbie.protocol.monitor;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.protocol.order.PlayerNumber;

/**
 * What the materials of a node reveal about a robot: {@code matNum7} its number, {@code matLeft} its team, {@code matType1} its
 * robot type.
 *
 * @param player team and number, if one mesh carries both
 * @param type the robot type; type 0 if no mesh shows it
 */
record MonitoredMaterials(Optional<PlayerNumber> player, RobotType type) {

    private static final String NUMBER = "matNum";
    private static final String TYPE = "matType";

    static MonitoredMaterials of(TransformNode root) {
        Optional<PlayerNumber> player = meshes(root)
                .map(mesh -> player(mesh.materials()))
                .flatMap(Optional::stream)
                .findFirst();
        int type = meshes(root)
                .flatMap(mesh -> mesh.materials().stream())
                .filter(material -> material.startsWith(TYPE))
                .mapToInt(material -> numberAfter(material, TYPE))
                .filter(number -> number >= 0 && number < RobotType.values().length)
                .findFirst()
                .orElse(0);
        return new MonitoredMaterials(player, RobotType.values()[type]);
    }

    /** Lists the mesh files of a node and of all nodes in it. */
    static Stream<String> meshNames(TransformNode root) {
        return meshes(root)
                .map(MeshNode::form)
                .filter(form -> form instanceof MeshNode.MeshFile)
                .map(MeshNode.Form::name);
    }

    private static Stream<MeshNode> meshes(SceneNode node) {
        if (node instanceof MeshNode mesh) {
            return Stream.of(mesh);
        }
        return node instanceof TransformNode transform
                ? transform.children().stream().flatMap(MonitoredMaterials::meshes)
                : Stream.empty();
    }

    private static Optional<PlayerNumber> player(List<String> materials) {
        return materials.stream()
                .filter(material -> material.startsWith(NUMBER))
                .map(material -> numberAfter(material, NUMBER))
                .filter(number -> number > 0)
                .findFirst()
                .flatMap(number -> side(materials).map(side -> new PlayerNumber(side, number)));
    }

    private static Optional<TeamSide> side(List<String> materials) {
        if (materials.contains("matLeft")) {
            return Optional.of(TeamSide.LEFT);
        }
        return materials.contains("matRight") ? Optional.of(TeamSide.RIGHT) : Optional.empty();
    }

    private static int numberAfter(String material, String prefix) {
        String digits = material.substring(prefix.length());
        boolean plain = !digits.isEmpty()
                && digits.length() < 4
                && digits.chars().allMatch(character -> character >= '0' && character <= '9');
        return plain ? Integer.parseInt(digits) : -1;
    }
}
