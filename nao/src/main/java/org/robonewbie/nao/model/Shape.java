package org.robonewbie.nao.model;

import org.robonewbie.nao.Vector3;

/** The solid form of a link, in metres; its centre is the link's origin and its mass is spread evenly. */
public sealed interface Shape {

    /**
     * A box.
     *
     * @param size edge lengths along x, y and z in metres
     */
    record Box(Vector3 size) implements Shape {}

    /**
     * A sphere.
     *
     * @param radius in metres
     */
    record Sphere(double radius) implements Shape {}

    /**
     * A cylinder along z with half a sphere at each end.
     *
     * @param radius of cylinder and half spheres in metres
     * @param length of the cylinder without the half spheres in metres
     */
    record Capsule(double radius, double length) implements Shape {}
}
