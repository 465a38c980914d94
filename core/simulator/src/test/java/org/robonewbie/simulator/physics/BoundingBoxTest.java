package org.robonewbie.simulator.physics;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.Shape;

class BoundingBoxTest {

    private static final BodyPose TURNED = new BodyPose(new Vector3(1, 2, 3), RotationMatrix.aboutZ(Math.PI / 2));

    @Test
    void turnedBoxSwapsItsSides() {
        assertBox(BoundingBox.of(new Shape.Box(new Vector3(2, 4, 6)), TURNED), new Vector3(2, 1, 3));
    }

    @Test
    void sphereIsTheSameInEveryPose() {
        assertBox(BoundingBox.of(new Shape.Sphere(0.5), TURNED), new Vector3(0.5, 0.5, 0.5));
    }

    @Test
    void capsuleStandsAlongItsZAxis() {
        assertBox(BoundingBox.of(new Shape.Capsule(0.5, 2), TURNED), new Vector3(0.5, 0.5, 1.5));
    }

    @Test
    void unionHoldsBoth() {
        BoundingBox one = new BoundingBox(new Vector3(0, 5, 0), new Vector3(1, 6, 1));
        BoundingBox two = new BoundingBox(new Vector3(-1, 7, 0.5), new Vector3(0, 8, 2));

        assertThat(one.union(two)).isEqualTo(new BoundingBox(new Vector3(-1, 5, 0), new Vector3(1, 8, 2)));
    }

    private static void assertBox(BoundingBox box, Vector3 half) {
        assertThat(box.min().distanceTo(TURNED.position().minus(half))).isLessThan(1e-12);
        assertThat(box.max().distanceTo(TURNED.position().plus(half))).isLessThan(1e-12);
    }
}
