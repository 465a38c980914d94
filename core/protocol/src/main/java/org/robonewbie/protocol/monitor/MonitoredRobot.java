package org.robonewbie.protocol.monitor;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.model.Link;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.protocol.order.PlayerNumber;

/** A robot in the monitored scene. Each message that is applied updates the transforms of its links. */
public final class MonitoredRobot {

    private static final String NUMBER = "matNum";
    private static final String TYPE = "matType";

    private final PlayerNumber player;
    private final RobotType type;
    private final Map<String, TransformNode> links;

    private MonitoredRobot(PlayerNumber player, RobotType type, Map<String, TransformNode> links) {
        this.player = player;
        this.type = type;
        this.links = links;
    }

    /**
     * Recognises a robot by its materials: {@code matNum7} is its number, {@code matLeft} its team and {@code matType1}
     * its type. One mesh must have both the number and the team material.
     */
    static Optional<MonitoredRobot> of(TransformNode root) {
        return root.meshes()
                .flatMap(mesh -> player(mesh.materials()).stream())
                .findFirst()
                .map(player -> new MonitoredRobot(player, type(root), links(root)));
    }

    /** {@return the robot's team and number} */
    public PlayerNumber player() {
        return player;
    }

    /** {@return the robot type; type 0 if the scene does not indicate it} */
    public RobotType type() {
        return type;
    }

    /**
     * Returns the pose of a link in the world frame.
     *
     * @param name a link's name in {@link NaoModel}, such as {@link NaoModel#TORSO}
     * @return its transform; empty if robots on this server have no such link
     */
    public Optional<TransformNode> link(String name) {
        return Optional.ofNullable(links.get(name));
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

    private static RobotType type(TransformNode root) {
        int type = root.meshes()
                .flatMap(mesh -> mesh.materials().stream())
                .filter(material -> material.startsWith(TYPE))
                .mapToInt(material -> numberAfter(material, TYPE))
                .filter(number -> number >= 0 && number < RobotType.values().length)
                .findFirst()
                .orElse(0);
        return RobotType.values()[type];
    }

    private static int numberAfter(String material, String prefix) {
        String digits = material.substring(prefix.length());
        boolean plain = !digits.isEmpty()
                && digits.length() < 4
                && digits.chars().allMatch(character -> character >= '0' && character <= '9');
        return plain ? Integer.parseInt(digits) : -1;
    }

    private static Map<String, TransformNode> links(TransformNode root) {
        List<Link> expected = NaoModel.of(type(root)).links();
        Map<String, TransformNode> found = new LinkedHashMap<>();
        boolean complete = root.children().size() == expected.size();
        for (int i = 0; i < root.children().size(); i++) {
            if (root.children().get(i) instanceof TransformNode part) {
                if (complete) {
                    found.put(expected.get(i).name(), part);
                } else {
                    nameByMesh(part, expected).ifPresent(name -> found.putIfAbsent(name, part));
                }
            }
        }
        return found;
    }

    /** Identifies a link of an unknown robot type by the name of its mesh file. */
    private static Optional<String> nameByMesh(TransformNode part, List<Link> expected) {
        return part.meshFiles()
                .findFirst()
                .flatMap(mesh ->
                        expected.stream().map(Link::name).filter(mesh::contains).findFirst());
    }
}
