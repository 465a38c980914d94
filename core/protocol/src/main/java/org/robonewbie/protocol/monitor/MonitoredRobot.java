package org.robonewbie.protocol.monitor;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robonewbie.nao.model.Link;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.protocol.order.PlayerNumber;

/** A robot as a monitor sees it; its links move with each message that is read. */
public final class MonitoredRobot {

    private final PlayerNumber player;
    private final RobotType type;
    private final Map<String, TransformNode> links;

    private MonitoredRobot(PlayerNumber player, RobotType type, Map<String, TransformNode> links) {
        this.player = player;
        this.type = type;
        this.links = links;
    }

    /** Recognises a robot by its number and its team's colour. */
    static Optional<MonitoredRobot> of(TransformNode root) {
        return MonitoredMaterials.of(root)
                .player()
                .map(player -> new MonitoredRobot(
                        player,
                        MonitoredMaterials.of(root).type(),
                        links(root, MonitoredMaterials.of(root).type())));
    }

    /** {@return the robot's team and number} */
    public PlayerNumber player() {
        return player;
    }

    /** {@return the robot type} */
    public RobotType type() {
        return type;
    }

    /**
     * Finds the pose of a link in the world frame.
     *
     * @param name a link's name in {@link NaoModel}, such as {@link NaoModel#TORSO}
     * @return its transform; empty for a link that this server's robots do not have
     */
    public Optional<TransformNode> link(String name) {
        return Optional.ofNullable(links.get(name));
    }

    private static Map<String, TransformNode> links(TransformNode root, RobotType type) {
        List<Link> expected = NaoModel.of(type).links();
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

    /** In a robot of another type only the links with a mesh of their own can be told apart. */
    private static Optional<String> nameByMesh(TransformNode part, List<Link> expected) {
        return MonitoredMaterials.meshNames(part)
                .findFirst()
                .flatMap(mesh ->
                        expected.stream().map(Link::name).filter(mesh::contains).findFirst());
    }
}
