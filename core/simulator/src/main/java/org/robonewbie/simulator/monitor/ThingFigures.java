package org.robonewbie.simulator.monitor;

import java.util.ArrayList;
import java.util.List;
import org.robonewbie.protocol.monitor.MeshNode;
import org.robonewbie.protocol.monitor.MeshNode.StandardShape;
import org.robonewbie.protocol.monitor.TransformNode;
import org.robonewbie.simulator.landscape.Thing;
import org.robonewbie.simulator.physics.BodyPose;

/** The things of a landscape in the scene: a grey box for each, in the words in which SimSpark describes the outer walls. */
final class ThingFigures {

    private List<Thing> shown = List.of();
    private final List<TransformNode> nodes = new ArrayList<>();

    List<TransformNode> nodes() {
        return nodes;
    }

    /** Takes the newest state; returns whether there are other things than before, which only a full message can show. */
    boolean update(List<Thing> things) {
        boolean changed = things.size() != shown.size();
        for (int i = 0; !changed && i < things.size(); i++) {
            changed = !things.get(i).size().equals(shown.get(i).size());
        }
        if (changed) {
            nodes.clear();
            things.forEach(thing -> nodes.add(TransformNode.at(0, 0, 0, box(thing))));
        }
        shown = things;
        for (int i = 0; i < things.size(); i++) {
            float[] place = new float[16];
            MonitoredRobotState.writePlace(BodyPose.of(things.get(i).pose()), place, 0);
            nodes.get(i).moveTo(place, 0);
        }
        return changed;
    }

    private static MeshNode box(Thing thing) {
        return new MeshNode(
                new StandardShape("StdUnitBox", List.of()),
                (float) thing.size().x(),
                (float) thing.size().y(),
                (float) thing.size().z(),
                List.of("matGrey"),
                false,
                true);
    }
}
