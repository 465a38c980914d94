package org.robonewbie.nao.model;

import org.robonewbie.nao.Vector3;

/** The solid shape of a link. Its centre is the link's origin, and its density is uniform. */
public sealed interface Shape {

    /** {@return the size of the bounding box along x, y and z in metres} */
    Vector3 size();

    /**
     * A box.
     *
     * @param size edge lengths along x, y and z in metres
     */
    record Box(Vector3 size) implements Shape {}

    /**
     * A sphere.
     *
     * @param radius radius in metres
     */
    record Sphere(double radius) implements Shape {

        @Override
        public Vector3 size() {
            return new Vector3(2 * radius, 2 * radius, 2 * radius);
        }
    }

    /**
     * A cylinder along z with a hemisphere at each end.
     *
     * @param radius radius of cylinder and hemispheres in metres
     * @param length length of the cylinder without the hemispheres in metres
     */
    record Capsule(double radius, double length) implements Shape {

        @Override
        public Vector3 size() {
            return new Vector3(2 * radius, 2 * radius, length + 2 * radius);
        }
    }
}
