package org.robonewbie.simulator.physics;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.MassDistribution;
import org.robonewbie.nao.model.Shape;

/** Against the moments that SimSpark's NAO and ball have. */
class MassDistributionTest {

    @Test
    void boxAsTheTorso() {
        assertInertia(new Shape.Box(new Vector3(0.10, 0.10, 0.18)), 1.2171, 4.300e-3, 4.300e-3, 2.029e-3);
    }

    @Test
    void boxAsTheFoot() {
        assertInertia(new Shape.Box(new Vector3(0.08, 0.16, 0.02)), 0.2, 4.333e-4, 1.133e-4, 5.333e-4);
    }

    @Test
    void sphereAsTheBall() {
        assertInertia(new Shape.Sphere(0.042), 0.026, 1.835e-5, 1.835e-5, 1.835e-5);
    }

    @Test
    void capsuleAsTheNeck() {
        assertInertia(new Shape.Capsule(0.015, 0.08), 0.05, 4.498e-5, 4.498e-5, 5.40e-6);
    }

    private static void assertInertia(Shape shape, double massKg, double x, double y, double z) {
        MassDistribution mass = MassDistribution.of(shape, massKg);

        assertThat(mass.massKg()).isEqualTo(massKg);
        assertThat(mass.inertia().x() / x).isBetween(0.999, 1.001);
        assertThat(mass.inertia().y() / y).isBetween(0.999, 1.001);
        assertThat(mass.inertia().z() / z).isBetween(0.999, 1.001);
    }
}
