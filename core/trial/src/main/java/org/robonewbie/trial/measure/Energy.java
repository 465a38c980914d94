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
 * The mechanical work of the motors in joules: the sum of all per-cycle increases in the potential and kinetic energy of the
 * limbs. Braking neither costs nor recovers energy.
 */
public final class Energy extends MeasureFromStart {

    private static final double GRAVITY = 9.81;

    private List<Vector3> positionsBefore = List.of();
    private double energyBefore;
    private double joules;

    /** Creates the measure. */
    public Energy() {
        super("J", false);
    }

    @Override
    protected void see(WorldState first, WorldState now) {
        BodyState body = now.robot();
        List<Link> links = NaoModel.of(body.type()).links();
        BodyPoses poses = body.limbs();
        List<Vector3> positions =
                links.stream().map(link -> poses.link(link.name()).position()).toList();
        boolean isFirst = positionsBefore.isEmpty();
        double energy = 0;
        for (int i = 0; i < positions.size(); i++) {
            double speed = isFirst ? 0 : positions.get(i).distanceTo(positionsBefore.get(i)) / Cycle.SECONDS;
            energy += links.get(i).massKg() * (GRAVITY * positions.get(i).z() + speed * speed / 2);
        }
        joules += isFirst ? 0 : Math.max(0, energy - energyBefore);
        positionsBefore = positions;
        energyBefore = energy;
    }

    @Override
    public double value() {
        return joules;
    }
}
