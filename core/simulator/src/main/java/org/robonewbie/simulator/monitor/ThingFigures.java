package org.robonewbie.simulator.monitor;

import java.util.ArrayList;
import java.util.List;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.monitor.MeshNode;
import org.robonewbie.protocol.monitor.TransformNode;
import org.robonewbie.simulator.landscape.Thing;
import org.robonewbie.simulator.physics.BodyPose;

/** The objects of a landscape in the monitors' scene, drawn as grey boxes like the outer walls. */
final class ThingFigures {

    private List<Thing> shown = List.of();
    private final List<TransformNode> nodes = new ArrayList<>();

    List<TransformNode> nodes() {
        return nodes;
    }

    /**
     * Updates the nodes; returns whether the number or the sizes of the objects have changed, which requires a full
     * message.
     */
    boolean update(List<Thing> things) {
        boolean changed = things.size() != shown.size();
        for (int i = 0; !changed && i < things.size(); i++) {
            changed = !things.get(i).size().equals(shown.get(i).size());
        }
        if (changed) {
            nodes.clear();
            for (Thing thing : things) {
                Vector3 size = thing.size();
                MeshNode box = PitchScene.box((float) size.x(), (float) size.y(), (float) size.z());
                nodes.add(TransformNode.at(0, 0, 0, box));
            }
        }
        shown = things;
        for (int i = 0; i < things.size(); i++) {
            nodes.get(i)
                    .moveTo(
                            MonitoredRobotState.transform(
                                    BodyPose.of(things.get(i).pose())),
                            0);
        }
        return changed;
    }
}
