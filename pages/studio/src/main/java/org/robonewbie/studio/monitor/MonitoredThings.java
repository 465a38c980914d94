package org.robonewbie.studio.monitor;

import java.util.List;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.monitor.MeshNode;
import org.robonewbie.protocol.monitor.MonitoredWorld;
import org.robonewbie.protocol.monitor.SceneNode;
import org.robonewbie.protocol.monitor.TransformNode;
import org.robonewbie.simulator.landscape.Thing;
import org.robonewbie.simulator.physics.BodyPose;

/**
 * Finds obstacles in the scene graph from a monitor port. RoboNewbie's simulator lists them as boxes at the top level, after
 * the ball. Boxes before the ball are the walls of a SimSpark server, and boxes at lower levels are parts of robots.
 */
final class MonitoredThings {

    private static final String BOX = "StdUnitBox";

    private MonitoredThings() {}

    static List<Thing> of(MonitoredWorld world) {
        List<SceneNode> scene = world.scene();
        int ball = world.ball().map(scene::indexOf).orElse(-1);
        return scene.subList(ball + 1, scene.size()).stream()
                .filter(node -> node instanceof TransformNode)
                .map(node -> (TransformNode) node)
                .filter(MonitoredThings::isBox)
                .map(MonitoredThings::thing)
                .toList();
    }

    private static boolean isBox(TransformNode node) {
        return node.children().size() == 1
                && node.children().get(0) instanceof MeshNode mesh
                && mesh.form() instanceof MeshNode.StandardShape shape
                && shape.name().equals(BOX);
    }

    private static Thing thing(TransformNode node) {
        MeshNode box = (MeshNode) node.children().get(0);
        BodyPose pose = new BodyPose(node.position(), MonitorSnapshots.rotation(node));
        return Thing.fixed("box", new Vector3(box.scaleX(), box.scaleY(), box.scaleZ()), node.position())
                .at(pose.toPose());
    }
}
