package org.robonewbie.trial.measure;

import java.util.List;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.BodyPoses;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.nao.model.Link;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.trial.WorldState;

/**
 * Work with which the motors lift and speed up the limbs, in joules: each cycle counts by how much the energy of height and
 * movement of all limbs together has grown. What the motors brake costs nothing, as with motors that only warm up by it.
 */
public final class Energy extends MeasureFromStart {

    private static final double GRAVITY = 9.81;

    private List<Vector3> placesBefore = List.of();
    private double energyBefore;
    private double joules;

    /** Creates a measure that has not seen anything. */
    public Energy() {}

    @Override
    protected void see(WorldState first, WorldState now) {
        BodyState body = now.robot();
        List<Link> links = NaoModel.of(body.type()).links();
        BodyPoses poses = body.limbs();
        List<Vector3> places =
                links.stream().map(link -> poses.link(link.name()).position()).toList();
        double energy = 0;
        for (int i = 0; i < places.size(); i++) {
            double speed = placesBefore.isEmpty() ? 0 : places.get(i).distanceTo(placesBefore.get(i)) / Cycle.SECONDS;
            energy += links.get(i).massKg() * (GRAVITY * places.get(i).z() + speed * speed / 2);
        }
        joules += placesBefore.isEmpty() ? 0 : Math.max(0, energy - energyBefore);
        placesBefore = places;
        energyBefore = energy;
    }

    @Override
    public double value() {
        return joules;
    }

    @Override
    public String unit() {
        return "J";
    }

    @Override
    public boolean isLargerBetter() {
        return false;
    }
}
