package org.robonewbie.learning.objective;

import java.util.List;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.Link;
import org.robonewbie.simulator.world.Robot;

/**
 * Adds up the work with which a robot lifts and speeds up its limbs: each cycle counts by how much the energy of height and
 * movement of all limbs together has grown. What the motors brake costs nothing, as with motors that only warm up by it.
 */
final class LimbWork {

    private static final double GRAVITY = 9.81;

    private final Robot robot;
    private final List<Link> links;
    private Vector3[] places;
    private double energy;
    private double joules;

    LimbWork(Robot robot) {
        this.robot = robot;
        this.links = robot.model().links();
        this.places = places();
        this.energy = energy(places);
    }

    /** Adds the work since the last call. */
    void add() {
        Vector3[] now = places();
        double energyNow = energy(now);
        joules += Math.max(0, energyNow - energy);
        places = now;
        energy = energyNow;
    }

    /** The work so far. */
    double joules() {
        return joules;
    }

    private double energy(Vector3[] now) {
        double sum = 0;
        for (int i = 0; i < now.length; i++) {
            double speed = now[i].distanceTo(places[i]) / Cycle.SECONDS;
            sum += links.get(i).massKg() * (GRAVITY * now[i].z() + speed * speed / 2);
        }
        return sum;
    }

    private Vector3[] places() {
        Vector3[] result = new Vector3[links.size()];
        for (int i = 0; i < result.length; i++) {
            result[i] = robot.linkPose(i).position();
        }
        return result;
    }
}
